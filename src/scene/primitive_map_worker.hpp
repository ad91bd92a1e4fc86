#pragma once

#include "src/scene/primitive_map_job.hpp"

namespace edgeshade {

/// Builds a scene's primitive maps where there are no threads, but others who can work beside the
/// drawing: a page's web worker. One map at a time.
class PrimitiveMapWorker {
  public:
    virtual ~PrimitiveMapWorker() = default;

    /// False: it can't, or can't any more; who asks has to build.
    virtual bool works() const = 0;
    /// Begins; what was asked before is given up.
    virtual void ask(const PrimitiveMapTask& task) = 0;
    virtual void giveUp() = 0;
    /// What was asked for, once it is there.
    virtual std::optional<BuiltPrimitiveMap> take() = 0;
};

} // namespace edgeshade
