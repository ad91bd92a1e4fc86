// tinygltf, compiled once. It gets only the JSON: our own code reads and checks files and images.
#define TINYGLTF_IMPLEMENTATION
#include <fstream> // tiny_gltf.h doesn't include it without a file system
#include <tiny_gltf.h>
