# Installed headers and the CMake package for plug-ins built out of tree.
