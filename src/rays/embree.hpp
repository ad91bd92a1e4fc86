#pragma once

// Embree 3 or 4, whose calls differ. CMake says which by EDGESHADE_EMBREE. Only sources include
// this.

#if EDGESHADE_EMBREE >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace edgeshade::rays::embree {

#if EDGESHADE_EMBREE >= 4

using Context = RTCRayQueryContext;

inline void init(Context& context) {
    rtcInitRayQueryContext(&context);
}

inline RTCOccludedArguments argumentsOf(Context& context, bool coherent) {
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.context = &context;
    arguments.flags = coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
    return arguments;
}

/// Whether something stops the ray: then its tfar is -infinity.
inline void occluded(RTCScene scene, Context& context, RTCRay& ray) {
    RTCOccludedArguments arguments = argumentsOf(context, false);
    rtcOccluded1(scene, &ray, &arguments);
}

/// Finds where the ray ends first: near boxes are visited first.
inline void intersect(RTCScene scene, Context& context, RTCRayHit& ray) {
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &context;
    rtcIntersect1(scene, &ray, &arguments);
}

/// As the first, for coherent rays, those with valid[i] = -1.
inline void occluded(RTCScene scene, Context& context, const int* valid, RTCRay8& rays) {
    RTCOccludedArguments arguments = argumentsOf(context, true);
    rtcOccluded8(valid, scene, &rays, &arguments);
}
inline void occluded(RTCScene scene, Context& context, const int* valid, RTCRay16& rays) {
    RTCOccludedArguments arguments = argumentsOf(context, true);
    rtcOccluded16(valid, scene, &rays, &arguments);
}

#else

using Context = RTCIntersectContext;

inline void init(Context& context) {
    rtcInitIntersectContext(&context);
}

/// Whether something stops the ray: then its tfar is -infinity.
inline void occluded(RTCScene scene, Context& context, RTCRay& ray) {
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    rtcOccluded1(scene, &context, &ray);
}

/// Finds where the ray ends first: near boxes are visited first.
inline void intersect(RTCScene scene, Context& context, RTCRayHit& ray) {
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    rtcIntersect1(scene, &context, &ray);
}

/// As the first, for coherent rays, those with valid[i] = -1.
inline void occluded(RTCScene scene, Context& context, const int* valid, RTCRay8& rays) {
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcOccluded8(valid, scene, &context, &rays);
}
inline void occluded(RTCScene scene, Context& context, const int* valid, RTCRay16& rays) {
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcOccluded16(valid, scene, &context, &rays);
}

#endif

} // namespace edgeshade::rays::embree
