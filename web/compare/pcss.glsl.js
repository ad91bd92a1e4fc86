// Percentage-closer soft shadows (Fernando 2005) of one extended light, from three.js's own maps:
// the height of the blockers above a surface gives the width of its shadow's edge. Replaces the
// single lookup that three.js makes without a filter (BasicShadowMap).

/** Lookups in each of the two steps. */
const taps = 24;

const functions = /* glsl */`
#if defined( USE_SHADOWMAP ) && defined( SHADOWMAP_TYPE_BASIC )

uniform float pcssSize;     // a lamp's radius; of a sun the tangent of half its angle
uniform vec3 pcssExtent;    // of what a sun's map holds: width, height, depth

// The i-th point of a disc that is filled evenly, turned by another angle in each pixel.
vec2 pcssPoint( int i, float turn ) {
	float angle = float( i ) * 2.39996323 + turn;
	return sqrt( ( float( i ) + 0.5 ) / float( ${taps} ) ) * vec2( cos( angle ), sin( angle ) );
}

float pcssTurn() {
	return 6.2831853 * fract( 52.9829189 * fract( dot( gl_FragCoord.xy, vec2( 0.06711056, 0.00583715 ) ) ) );
}

#if NUM_DIR_LIGHT_SHADOWS > 0
float pcssSun( sampler2D map, vec2 mapSize, float intensity, float bias, float unused, vec4 coord ) {
	vec3 here = coord.xyz / coord.w;
	here.z += bias;
	if ( any( lessThan( here, vec3( 0.0 ) ) ) || any( greaterThan( here, vec3( 1.0 ) ) ) ) return 1.0;
	float turn = pcssTurn();
	vec2 reach = pcssSize * pcssExtent.z / pcssExtent.xy; // of the map, for blockers a whole depth above
	float sum = 0.0, blockers = 0.0;
	for ( int i = 0; i < ${taps}; i ++ ) {
		float depth = texture2D( map, here.xy + pcssPoint( i, turn ) * reach * here.z ).r;
		if ( depth < here.z ) {
			sum += depth;
			blockers += 1.0;
		}
	}
	if ( blockers == 0.0 ) return 1.0;
	vec2 wide = max( reach * ( here.z - sum / blockers ), 0.5 / mapSize );
	float lit = 0.0;
	for ( int i = 0; i < ${taps}; i ++ )
		lit += step( here.z, texture2D( map, here.xy + pcssPoint( i, turn ) * wide ).r );
	return mix( 1.0, lit / float( ${taps} ), intensity );
}
#endif

#if NUM_POINT_LIGHT_SHADOWS > 0
float pcssLamp( samplerCube map, vec2 mapSize, float intensity, float bias, float unused, vec4 coord, float near, float far ) {
	vec3 ray = coord.xyz;
	float away = length( ray );
	vec3 toward = ray / away;
	vec3 side = normalize( cross( toward, abs( toward.x ) > 0.7 ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 ) ) );
	vec3 up = cross( toward, side );
	float turn = pcssTurn();
	// Blockers are looked for down to a quarter of the way from the lamp.
	float reach = pcssSize * 3.0 / away;
	float sum = 0.0, blockers = 0.0;
	for ( int i = 0; i < ${taps}; i ++ ) {
		vec2 at = pcssPoint( i, turn ) * reach;
		vec3 ask = normalize( toward + at.x * side + at.y * up );
		float axis = max( max( abs( ask.x ), abs( ask.y ) ), abs( ask.z ) );
		float own = far / ( far - near ) + bias - near * far / ( ( far - near ) * away * axis );
		float depth = textureCube( map, ask ).r;
		if ( depth < own ) {
			sum += near * far / ( ( far - depth * ( far - near ) ) * axis );
			blockers += 1.0;
		}
	}
	if ( blockers == 0.0 ) return 1.0;
	float wide = max( pcssSize * ( away * blockers / sum - 1.0 ) / away, 0.5 / mapSize.x );
	float lit = 0.0;
	for ( int i = 0; i < ${taps}; i ++ ) {
		vec2 at = pcssPoint( i, turn ) * wide;
		vec3 ask = normalize( toward + at.x * side + at.y * up );
		float axis = max( max( abs( ask.x ), abs( ask.y ) ), abs( ask.z ) );
		lit += step( far / ( far - near ) + bias - near * far / ( ( far - near ) * away * axis ), textureCube( map, ask ).r );
	}
	return mix( 1.0, lit / float( ${taps} ), intensity );
}
#endif

#endif
`;

/** Throws if the text hasn't what is wanted. */
export function replaced(text, wanted, by) {
  if (!text.includes(wanted)) throw new Error(`This release of three.js has no '${wanted}' to put other shadows in place of.`);
  return text.replaceAll(wanted, by);
}

/** `chunks`: three.js's ShaderChunk. */
export function withPcss(source, chunks) {
  const declared = '#include <shadowmap_pars_fragment>', lights = '#include <lights_fragment_begin>';
  const asked = replaced(replaced(chunks.lights_fragment_begin, 'getShadow( directionalShadowMap', 'pcssSun( directionalShadowMap'),
    'getPointShadow( pointShadowMap', 'pcssLamp( pointShadowMap');
  return replaced(replaced(source, declared, `${declared}\n${functions}`), lights, asked);
}
