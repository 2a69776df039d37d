// A shadow map keeps depth alone.
void main() {}
