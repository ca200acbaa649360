// SPDX-License-Identifier: BSD-3-Clause
// The source of the targets that own the precompiled headers, some of which are programs; see
// SlalomPrecompiled.cmake.
int main() {}
