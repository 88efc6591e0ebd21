// Does nothing: its executable, test_pch, carries the precompiled headers of the tests (ARRIS_PCH).
int main() {}
