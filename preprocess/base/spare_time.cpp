#include "preprocess/base/spare_time.hpp"

#ifdef __linux__
#include <pthread.h>
#endif

namespace edgeshade {

void takeSpareTimeAlone() {
#ifdef __linux__
    const sched_param parameters{};
    pthread_setschedparam(pthread_self(), SCHED_IDLE, &parameters);
#endif
}

} // namespace edgeshade
