// Shadows by a ray for each fragment, through a tree of boxes (three-mesh-bvh): exact up to the
// ray's offset, at the price of walking the tree in every pixel.

import { BufferAttribute, BufferGeometry, Matrix4, ShaderChunk, Vector3 } from 'three';
import { BVHShaderGLSL, MeshBVH, MeshBVHUniformStruct } from 'three-mesh-bvh';
import { Method } from './method.js';
import { replaced } from './pcss.glsl.js';

/** Share of the scene's radius by which rays begin off their surface. */
const offset = 1e-4;

const functions = /* glsl */`
precision highp isampler2D;
precision highp usampler2D;
${BVHShaderGLSL.common_functions}
${BVHShaderGLSL.bvh_struct_definitions}
${BVHShaderGLSL.bvh_ray_functions}

uniform BVH casters;
uniform mat4 worldFromView;
uniform float rayOffset;

bool blockedInLeaf( uint first, uint count, vec3 from, vec3 along, float end ) {
	vec3 share, normal;
	float at, side;
	for ( uint i = first; i < first + count; i ++ ) {
		uvec3 corners = uTexelFetch1D( casters.index, i ).xyz;
		vec3 a = texelFetch1D( casters.position, corners.x ).xyz;
		vec3 b = texelFetch1D( casters.position, corners.y ).xyz;
		vec3 c = texelFetch1D( casters.position, corners.z ).xyz;
		if ( intersectsTriangle( from, along, a, b, c, share, normal, at, side ) && at > 0.0 && at < end ) return true;
	}
	return false;
}

// Whether any triangle lies within 'end' of a point, in units of 'along'.
bool blocked( vec3 from, vec3 along, float end ) {
	uint waiting[ BVH_STACK_DEPTH ];
	waiting[ 0 ] = 0u;
	for ( int top = 0; top >= 0 && top < BVH_STACK_DEPTH - 1; ) {
		uint node = waiting[ top -- ];
		float at;
		if ( ! intersectsBVHNodeBounds( from, along, casters.bvhBounds, node, at ) || at > end ) continue;
		uvec2 content = uTexelFetch1D( casters.bvhContents, node ).xy;
		if ( ( content.x & 0xffff0000u ) != 0u ) {
			if ( blockedInLeaf( content.y, content.x & 0xffffu, from, along, end ) ) return true;
			continue;
		}
		waiting[ ++ top ] = node + content.y;
		waiting[ ++ top ] = node + 1u;
	}
	return false;
}

// 'towards': to the light, in the view; 'end': how far it is.
float litByRay( vec3 towards, float end ) {
	vec3 place = - vViewPosition;
	vec3 side = normalize( cross( dFdx( place ), dFdy( place ) ) );
	if ( dot( side, towards ) < 0.0 ) side = - side;
	vec3 from = ( worldFromView * vec4( place + rayOffset * side, 1.0 ) ).xyz;
	return blocked( from, mat3( worldFromView ) * towards, end ) ? 0.0 : 1.0;
}
`;

/** Shaders of three.js that multiply the light by what the ray says. */
function withRays(source) {
  const main = 'void main() {', lights = '#include <lights_fragment_begin>';
  const sun = 'getDirectionalLightInfo( directionalLight, directLight );';
  const lamp = 'getPointLightInfo( pointLight, geometryPosition, directLight );';
  const asked = replaced(replaced(ShaderChunk.lights_fragment_begin,
    sun, `${sun}\ndirectLight.color *= litByRay( directLight.direction, 1e30 );`),
    lamp, `${lamp}\ndirectLight.color *= litByRay( directLight.direction, distance( pointLight.position, - vViewPosition ) );`);
  return replaced(replaced(source, main, `${functions}\n${main}`), lights, asked);
}

/** The triangles of all casters, in the world, as one geometry. */
function castersOf(model) {
  const positions = [], at = new Vector3(), place = new Matrix4();
  model.updateMatrixWorld(true);
  model.traverse((mesh) => {
    if (!mesh.isMesh || !mesh.castShadow) return;
    const { index, attributes } = mesh.geometry;
    const corners = index ? index.count : attributes.position.count;
    for (let instance = 0; instance < (mesh.isInstancedMesh ? mesh.count : 1); ++instance) {
      place.copy(mesh.matrixWorld);
      if (mesh.isInstancedMesh) {
        mesh.getMatrixAt(instance, place);
        place.premultiply(mesh.matrixWorld);
      }
      for (let corner = 0; corner < corners - (corners % 3); ++corner) {
        mesh.getVertexPosition(index ? index.getX(corner) : corner, at).applyMatrix4(place);
        positions.push(at.x, at.y, at.z);
      }
    }
  });
  return new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(positions), 3));
}

/** The tree is built once: casters that move afterwards keep their shadows. */
export class Rays extends Method {
  #tree = new MeshBVHUniformStruct();
  #uniforms = { casters: { value: this.#tree }, worldFromView: { value: new Matrix4() }, rayOffset: { value: 0 } };
  #built = false;

  change(material) {
    material.onBeforeCompile = (shader) => {
      Object.assign(shader.uniforms, this.#uniforms);
      shader.fragmentShader = withRays(shader.fragmentShader);
    };
    material.customProgramCacheKey = () => this.id;
  }

  render() {
    const { renderer, scene, camera, radius } = this.world;
    if (!this.#built) this.#tree.updateFrom(new MeshBVH(castersOf(scene)));
    this.#built = true;
    camera.updateMatrixWorld();
    this.#uniforms.worldFromView.value.copy(camera.matrixWorld);
    this.#uniforms.rayOffset.value = offset * radius;
    renderer.shadowMap.enabled = false;
    this.rig.light.castShadow = false;
    renderer.render(scene, camera);
  }

  bytes() {
    const { index, position, bvhBounds, bvhContents } = this.#tree;
    return [index, position, bvhBounds, bvhContents].reduce((sum, { image }) => sum + (image?.data?.byteLength ?? 0), 0);
  }

  dispose() {
    super.dispose();
    this.#tree.dispose();
  }
}
