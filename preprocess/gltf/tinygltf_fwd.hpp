#pragma once

/// What headers say of tinygltf's types; sources that look into them include tinygltf_model.hpp.
namespace tinygltf {
class Model;
class Node;
struct Accessor;
struct Primitive;
} // namespace tinygltf
