#pragma once

#include <map>

namespace edgeshade::test {

/// The value of a key, which make() makes when it is first asked for.
template <class Key, class Value, class Make>
const Value& kept(std::map<Key, Value>& known, const Key& key, Make make) {
    const auto found = known.find(key);
    return found != known.end() ? found->second : known.emplace(key, make()).first->second;
}

} // namespace edgeshade::test
