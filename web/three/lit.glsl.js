// GLSL for three.js's fragment shaders: how much of a light reaches a fragment, by the masks or by
// its map.

import { lookupSource } from '../masks/lookup-source.js';

/** Most lights that can be looked up at once: each takes one of a material's textures. */
export const mostSlots = 4;

/** Prefix of the names of a slot's map. */
export const slotName = (slot) => `edgeshadeMap${slot}`;

/** Names of three.js's counts in shaders: of casting lights, which come first within each kind. */
const counts = { point: 'NUM_POINT_LIGHT_SHADOWS', spot: 'NUM_SPOT_LIGHT_SHADOWS', directional: 'NUM_DIR_LIGHT_SHADOWS' };

/** First channel of each kind's lights. */
const first = { point: '0', spot: counts.point, directional: `${counts.point} + ${counts.spot}` };

const all = Object.values(counts).join(' + ');

/** A loop, since a branch doesn't keep software renderers from sampling a map that isn't there. */
const askMap = (slot, { tints, soft }) => /* glsl */`
	${slotName(slot)}_primitiveHolds = edgeshadeHeld;
	for ( int i = 0; i < edgeshadeMaps[ ${slot} ]; i ++ )
		edgeshadeLooked[ ${slot} ] = ${slotName(slot)}_lit${tints ? 'Color' : ''}On( position, towardsEye, normal, error, edgeshadeCasts )${tints ? '' : ' ? 1.0 : 0.0'};
	${soft ? `for ( int i = 0; i < edgeshadeSoftMaps[ ${slot} ]; i ++ )
		edgeshadeLooked[ ${slot} ] = edgeshadeShare( ${slotName(slot)}_litShareOn( position, towardsEye, normal, error, edgeshadeCasts ) );` : ''}
`;

/** The type of a light's share: with tints by colour. */
const kindOf = ({ tints }) => (tints ? 'vec3' : 'float');

/** The lookups of maps, for as many slots as a material has room for. */
const lookups = (slots, casters) => Array.from({ length: slots }, (_, slot) => lookupSource(slotName(slot), casters)).join('\n') + /* glsl */`
uniform int edgeshadeMaps[ ${mostSlots} ]; // 1: there is one, of a light without a radius
uniform int edgeshadeSoftMaps[ ${mostSlots} ]; // 1: of a light with one
uniform bool edgeshadeCasts; // all that the material is on
uniform bool edgeshadeHeld;  // and maps hold them
edgeshadeShare edgeshadeLooked[ ${mostSlots} ];

void edgeshadeAskMaps( const in highp vec3 position ) {
	highp vec3 towardsEye = isOrthographic ? vec3( 0.0, 0.0, 1.0 ) : - position;
	highp vec3 along = dFdx( position ), up = dFdy( position ), normal = cross( along, up );
	highp float error = ${slots > 0 ? `${slotName(0)}_litError( position, along, up )` : '0.0'};
	${Array.from({ length: slots }, (_, slot) => askMap(slot, casters)).join('')}
}
`;

/** Goes before main(). A fragment normally takes the masks' texel at its pixel. At outlines
 * masks and picture may show different surfaces; there it takes the surrounding texel whose
 * nearness is closest to the fragment's own. */
export const declarations = (slots, casters) => /* glsl */`
#if ${all} > 0
#define edgeshadeShare ${kindOf(casters)}
${lookups(slots, casters)}
uniform mediump sampler2D edgeshadeMasks[ ( ${all} + 3 ) / 4 ];
uniform float edgeshadeIntensities[ ${all} ];
uniform highp sampler2D edgeshadeNearness;
uniform highp vec4 edgeshadeViewport; // x, y, 1 / width, 1 / height; 0: there are no shadows
uniform highp vec3 edgeshadeOwn;      // nearness by gl_FragCoord.w, depth and as it is
uniform highp vec4 edgeshadeRegion;    // lower left, upper right, in the viewport: elsewhere masks are 1
uniform int edgeshadeWays[ ${all} ];   // a light's channel of the masks; or -1 - the slot of its map; or with
                                       // both the channel + 32 * (1 + the slot)
uniform int edgeshadeMasked;           // 1: there are masks; 0: all lights are looked up

bool edgeshadeHasMasks() { // or maps
	return edgeshadeViewport.z > 0.0;
}

highp float edgeshadeNearnessAt( const in highp vec2 place ) {
	return dot( floor( texture2D( edgeshadeNearness, place ).rgb * 255.0 + 0.5 ), vec3( 65536.0, 256.0, 1.0 ) ) / 16777215.0;
}

highp vec2 edgeshadeFindTexel( const in highp float depth ) {
	highp vec2 place = ( gl_FragCoord.xy - edgeshadeViewport.xy ) * edgeshadeViewport.zw;
	highp float own = edgeshadeOwn.x * gl_FragCoord.w + edgeshadeOwn.y * depth + edgeshadeOwn.z;
	highp vec2 change = vec2( dFdx( own ), dFdy( own ) );
	highp float least = abs( edgeshadeNearnessAt( place ) - own );
	if ( least <= 0.1 * ( abs( change.x ) + abs( change.y ) ) + 1e-5 * own + 2.0 / 16777215.0 ) return place;
	highp vec2 found = place;
	for ( int j = - 1; j <= 1; j ++ ) for ( int i = - 1; i <= 1; i ++ ) {
		highp vec2 step = vec2( float( i ), float( j ) );
		highp vec2 there = place + step * edgeshadeViewport.zw;
		highp float apart = abs( edgeshadeNearnessAt( there ) - own - dot( change, step ) );
		if ( apart < least ) {
			least = apart;
			found = there;
		}
	}
	return found;
}

highp vec2 edgeshadeTexel;

float edgeshadeMaskOf( const in int channel ) {
#ifdef EDGESHADE_SEE_THROUGH
	return 1.0; // it isn't in the masks
#else
	vec4 found = texture2D( edgeshadeMasks[ 0 ], edgeshadeTexel );
	${Array.from({ length: 7 }, (_, i) => `
#if ${all} > ${4 * i + 4}
	if ( channel >= ${4 * i + 4} ) found = texture2D( edgeshadeMasks[ ${i + 1} ], edgeshadeTexel );
#endif`).join('')}
	return edgeshadeTexel.x < 0.0 ? 1.0 : found[ channel % 4 ];
#endif
}

edgeshadeShare edgeshadeLit( const in int light ) {
	int way = edgeshadeWays[ light ];
	edgeshadeShare lit = edgeshadeShare( 1.0 );
	if ( way < 0 ) lit = edgeshadeLooked[ - 1 - way ];
	else lit = edgeshadeShare( edgeshadeMaskOf( way % 32 ) );
	if ( way >= 32 ) lit *= edgeshadeLooked[ way / 32 - 1 ];
	return mix( edgeshadeShare( 1.0 ), lit, edgeshadeIntensities[ light ] );
}

float edgeshadeMean( const in edgeshadeShare share ) {
	return ${casters.tints ? 'dot( share, vec3( 1.0 / 3.0 ) )' : 'share'};
}

void edgeshadeFind( const in highp vec3 position ) {
	highp vec2 place = ( gl_FragCoord.xy - edgeshadeViewport.xy ) * edgeshadeViewport.zw;
	bool within = all( greaterThan( place, edgeshadeRegion.xy ) ) && all( lessThan( place, edgeshadeRegion.zw ) );
	edgeshadeTexel = vec2( - 1.0 );
	for ( int i = 0; i < ( within ? edgeshadeMasked : 0 ); i ++ ) edgeshadeTexel = edgeshadeFindTexel( - position.z );
	edgeshadeAskMaps( position );
}

#endif
`;

/** Goes before the lights are added up. */
const find = /* glsl */`
#if ${all} > 0
	if ( edgeshadeHasMasks() ) edgeshadeFind( - vViewPosition );
#endif
`;

const litBy = (kind) => /* glsl */`
		#if UNROLLED_LOOP_INDEX < ${counts[kind]}
		if ( edgeshadeHasMasks() && receiveShadow ) directLight.color *= edgeshadeLit( ${first[kind]} + UNROLLED_LOOP_INDEX );
		#endif
`;

/** The start of each light kind's part in three.js's chunk: a call, not a definition. */
const beginnings = { point: /getPointLightInfo\s*\(\s*\w+\s*,/, spot: /getSpotLightInfo\s*\(\s*\w+\s*,/,
  directional: /getDirectionalLightInfo\s*\(\s*\w+\s*,/ };

const declaresLight = /IncidentLight\s+directLight\s*;/;

/** lights_fragment_begin with masks, or a shader that contains it: scales each light by its mask
 * before adding it; without masks, three.js's own shadow map is sampled. Null if it isn't there. */
export function lightsWithMasks(source) {
  if (!declaresLight.test(source)) return null;
  let text = source;
  for (const [kind, begins] of Object.entries(beginnings)) {
    const begin = text.search(begins);
    const add = text.indexOf('RE_Direct(', begin);
    const unrolled = text.lastIndexOf('unroll_loop_start', begin) > text.lastIndexOf('unroll_loop_end', begin);
    if (begin < 0 || add < 0 || !unrolled) return null;
    text = text.slice(0, add) + litBy(kind).trimStart() + '\t\t' + text.slice(add);
  }
  return text.replace(declaresLight, (found) => found + find).replaceAll('directLight.visible && receiveShadow', 'directLight.visible && receiveShadow && ! edgeshadeHasMasks()');
}

/** The value of a ShadowMaterial, in place of getShadowMask(): the mean of the colours. */
export const shadowMask = /* glsl */`
float edgeshadeMask() {
#if ${all} > 0
	if ( ! edgeshadeHasMasks() ) return getShadowMask();
	if ( ! receiveShadow ) return 1.0;
	edgeshadeFind( - vViewPosition );
	edgeshadeShare lit = edgeshadeShare( 1.0 );
	#pragma unroll_loop_start
	for ( int i = 0; i < ${counts.point}; i ++ ) {
		lit *= edgeshadeLit( ${first.point} + UNROLLED_LOOP_INDEX );
	}
	#pragma unroll_loop_end
	#pragma unroll_loop_start
	for ( int i = 0; i < ${counts.spot}; i ++ ) {
		lit *= edgeshadeLit( ${first.spot} + UNROLLED_LOOP_INDEX );
	}
	#pragma unroll_loop_end
	#pragma unroll_loop_start
	for ( int i = 0; i < ${counts.directional}; i ++ ) {
		lit *= edgeshadeLit( ${first.directional} + UNROLLED_LOOP_INDEX );
	}
	#pragma unroll_loop_end
	return edgeshadeMean( lit );
#else
	return 1.0;
#endif
}
`;
