// What precompiled headers belong to; see SlalomPrecompiled.cmake.
