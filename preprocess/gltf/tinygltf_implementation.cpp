// tinygltf, compiled once. Files and images are read by our own code, which checks them; tinygltf
// gets the JSON alone.
#define TINYGLTF_IMPLEMENTATION
#include <fstream> // missing in tiny_gltf.h when it has no file system
#include <tiny_gltf.h>
