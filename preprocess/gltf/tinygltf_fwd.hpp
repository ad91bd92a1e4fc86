#pragma once

/// Forward declarations of tinygltf's types for headers; sources that use their members include
/// tinygltf_model.hpp.
namespace tinygltf {
class Model;
class Node;
struct Accessor;
struct Primitive;
} // namespace tinygltf
