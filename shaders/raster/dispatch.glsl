// The index of this invocation in a dispatch of Program::dispatch(): the grid of groups may be two-dimensional, because
// small devices allow no more than 65,535 groups in a row. Callers compare it with their count.
layout(local_size_x = 64) in;

uint linear_index() {
  return (gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x) * gl_WorkGroupSize.x + gl_LocalInvocationIndex;
}
