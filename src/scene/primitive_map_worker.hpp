#pragma once

#include "src/scene/primitive_map_job.hpp"

namespace edgeshade {

/// Builds a scene's primitive maps beside the drawing where there are no threads, as a page's web
/// worker does. One map at a time.
class PrimitiveMapWorker {
  public:
    virtual ~PrimitiveMapWorker() = default;

    /// False if it can't, or can't any more; the caller then has to build.
    virtual bool works() const = 0;
    /// Starts a task, and abandons the previous one.
    virtual void ask(const PrimitiveMapTask& task) = 0;
    virtual void giveUp() = 0;
    /// The result, once it is ready.
    virtual std::optional<BuiltPrimitiveMap> take() = 0;
};

} // namespace edgeshade
