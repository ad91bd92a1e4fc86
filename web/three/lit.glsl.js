// What three.js's fragment shaders ask: how much of a light reaches a fragment, by the masks.

/** Which counts three.js writes into shaders: of lights that cast, the first ones of each kind. */
const counts = { point: 'NUM_POINT_LIGHT_SHADOWS', spot: 'NUM_SPOT_LIGHT_SHADOWS', directional: 'NUM_DIR_LIGHT_SHADOWS' };

/** Where a kind's lights begin among the channels. */
const first = { point: '0', spot: counts.point, directional: `${counts.point} + ${counts.spot}` };

const all = Object.values(counts).join(' + ');

/** Ahead of main(). A fragment's own texel is that of the masks' pixel; at outlines, where the masks and the
 * picture may show other surfaces there, the texel around whose nearness is closest to the fragment's own. */
export const declarations = /* glsl */`
#if ${all} > 0

uniform mediump sampler2D edgeshadeMasks[ ( ${all} + 3 ) / 4 ];
uniform float edgeshadeIntensities[ ${all} ];
uniform highp sampler2D edgeshadeNearness;
uniform highp vec4 edgeshadeViewport; // x, y, 1 / width, 1 / height; 0: there are no masks
uniform highp vec3 edgeshadeOwn;      // nearness by gl_FragCoord.w, gl_FragCoord.z and as it is

bool edgeshadeHasMasks() {
	return edgeshadeViewport.z > 0.0;
}

highp float edgeshadeNearnessAt( const in highp vec2 place ) {
	return dot( floor( texture2D( edgeshadeNearness, place ).rgb * 255.0 + 0.5 ), vec3( 65536.0, 256.0, 1.0 ) ) / 16777215.0;
}

highp vec2 edgeshadeFindTexel() {
	highp vec2 place = ( gl_FragCoord.xy - edgeshadeViewport.xy ) * edgeshadeViewport.zw;
	highp float own = edgeshadeOwn.x * gl_FragCoord.w + edgeshadeOwn.y * gl_FragCoord.z + edgeshadeOwn.z;
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

#define EDGESHADE_LIT( light ) mix( 1.0, texture2D( edgeshadeMasks[ ( light ) / 4 ], edgeshadeTexel )[ ( light ) - ( light ) / 4 * 4 ], edgeshadeIntensities[ light ] )

#endif
`;

/** Before lights are added up. */
const findTexel = /* glsl */`
#if ${all} > 0
	edgeshadeTexel = edgeshadeHasMasks() ? edgeshadeFindTexel() : vec2( 0.0 );
#endif
`;

const litBy = (kind) => /* glsl */`
		#if UNROLLED_LOOP_INDEX < ${counts[kind]}
		if ( edgeshadeHasMasks() && receiveShadow ) directLight.color *= EDGESHADE_LIT( ${first[kind]} + UNROLLED_LOOP_INDEX );
		#endif
`;

/** How three.js begins the part of its chunk that each kind of light has. */
const beginnings = { point: 'getPointLightInfo(', spot: 'getSpotLightInfo(', directional: 'getDirectionalLightInfo(' };

/** lights_fragment_begin with masks: before each light is added, it is as bright as its mask says; its own map
 * is asked where there are no masks. */
export function lightsWithMasks(chunk) {
  let text = chunk;
  for (const [kind, begins] of Object.entries(beginnings)) {
    const begin = text.indexOf(begins);
    const add = text.indexOf('RE_Direct(', begin);
    if (begin < 0 || add < 0) throw new Error(`This release of three.js lights surfaces in a way that edgeshade does not know (${kind} lights).`);
    text = text.slice(0, add) + litBy(kind).trimStart() + '\t\t' + text.slice(add);
  }
  return findTexel + text.replaceAll('directLight.visible && receiveShadow', 'directLight.visible && receiveShadow && ! edgeshadeHasMasks()');
}

/** What a ShadowMaterial shows, in place of getShadowMask(). */
export const shadowMask = /* glsl */`
float edgeshadeMask() {
#if ${all} > 0
	if ( ! edgeshadeHasMasks() ) return getShadowMask();
	if ( ! receiveShadow ) return 1.0;
	edgeshadeTexel = edgeshadeFindTexel();
	float lit = 1.0;
	#pragma unroll_loop_start
	for ( int i = 0; i < ${counts.point}; i ++ ) {
		lit *= EDGESHADE_LIT( ${first.point} + UNROLLED_LOOP_INDEX );
	}
	#pragma unroll_loop_end
	#pragma unroll_loop_start
	for ( int i = 0; i < ${counts.spot}; i ++ ) {
		lit *= EDGESHADE_LIT( ${first.spot} + UNROLLED_LOOP_INDEX );
	}
	#pragma unroll_loop_end
	#pragma unroll_loop_start
	for ( int i = 0; i < ${counts.directional}; i ++ ) {
		lit *= EDGESHADE_LIT( ${first.directional} + UNROLLED_LOOP_INDEX );
	}
	#pragma unroll_loop_end
	return lit;
#else
	return 1.0;
#endif
}
`;
