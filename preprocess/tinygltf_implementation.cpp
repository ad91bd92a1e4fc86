// tinygltf, compiled once. Files and images are read by our own code, which checks them; tinygltf
// gets the JSON alone.
#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS
#include <fstream> // missing in tiny_gltf.h when it has no file system
#include <tiny_gltf.h>
