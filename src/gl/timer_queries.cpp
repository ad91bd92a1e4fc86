#include "src/gl/timer_queries.hpp"

#include "src/gl/entry_points.hpp"

#include <GLES2/gl2.h>
#include <GLES2/gl2ext.h>

namespace edgeshade::gl {
std::optional<TimerQueries> TimerQueries::find(const std::string& extensions,
                                               void* (*lookUp)(const char*)) {
    if (!listsExtension(extensions, "GL_EXT_disjoint_timer_query")) return std::nullopt;
    TimerQueries queries;
    GetParameter getParameter = nullptr;
    const bool complete = takeEntryPoint(queries.make_, lookUp, "glGenQueriesEXT") &&
                          takeEntryPoint(queries.destroy_, lookUp, "glDeleteQueriesEXT") &&
                          takeEntryPoint(queries.begin_, lookUp, "glBeginQueryEXT") &&
                          takeEntryPoint(queries.end_, lookUp, "glEndQueryEXT") &&
                          takeEntryPoint(queries.get32_, lookUp, "glGetQueryObjectuivEXT") &&
                          takeEntryPoint(queries.get64_, lookUp, "glGetQueryObjectui64vEXT") &&
                          takeEntryPoint(getParameter, lookUp, "glGetQueryivEXT");
    if (!complete) return std::nullopt;
    GLint bits = 0;
    getParameter(GL_TIME_ELAPSED_EXT, GL_QUERY_COUNTER_BITS_EXT, &bits);
    return bits > 0 ? std::optional(queries) : std::nullopt;
}

Name TimerQueries::make() const {
    Name query = 0;
    make_(1, &query);
    return query;
}

void TimerQueries::destroy(Name query) const {
    destroy_(1, &query);
}

void TimerQueries::begin(Name query) const {
    begin_(GL_TIME_ELAPSED_EXT, query);
}

void TimerQueries::end() const {
    end_(GL_TIME_ELAPSED_EXT);
}

bool TimerQueries::isReady(Name query) const {
    GLuint ready = GL_FALSE;
    get32_(query, GL_QUERY_RESULT_AVAILABLE_EXT, &ready);
    return ready != GL_FALSE;
}

std::uint64_t TimerQueries::nanoseconds(Name query) const {
    std::uint64_t value = 0;
    get64_(query, GL_QUERY_RESULT_EXT, &value);
    return value;
}

bool TimerQueries::wasDisturbed() const {
    return integerOf(GL_GPU_DISJOINT_EXT) != GL_FALSE;
}

} // namespace edgeshade::gl
