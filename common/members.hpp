// The members of a struct, listed once: whoever sends, saves, loads, prints or adds up its values visits them in that
// order, by their names.
#pragma once

#include <string_view>
#include <type_traits>

namespace stria {

template <class M, class T>
concept Is = std::is_same_v<std::remove_const_t<M>, T>;

/// Defines members(visitor, object), which calls visitor("a, b", object.a, object.b). It stands in the namespace of the
/// type, or in that of the visitors. It does not compile where a member is missing.
#define STRIA_MEMBERS(Type, ...)                                                                                       \
    void members(auto& visitor, stria::Is<Type> auto& object) {                                                        \
        auto& [__VA_ARGS__] = object;                                                                                  \
        visitor(#__VA_ARGS__, __VA_ARGS__);                                                                            \
    }

/// Of a list as a visitor gets it, one name after the other.
class MemberNames {
public:
    explicit MemberNames(std::string_view list) : left_(list) {}

    std::string_view next() {
        const std::string_view name = left_.substr(0, left_.find(','));
        left_.remove_prefix(name.size());
        left_.remove_prefix(left_.empty() ? 0 : std::string_view(", ").size());
        return name;
    }

private:
    std::string_view left_;
};

/// Calls take(name, member).
void for_each_member(auto& object, auto&& take) {
    auto visitor = [&](std::string_view names, auto&... values) {
        MemberNames list(names);
        (take(list.next(), values), ...);
    };
    members(visitor, object);
}

/// Each member of `sum` grows by that of `more`.
template <class M> M& add_members(M& sum, const M& more) {
    auto visit_sum = [&](std::string_view, auto&... sums) {
        auto visit_more = [&](std::string_view, const auto&... mores) { ((sums += mores), ...); };
        members(visit_more, more);
    };
    members(visit_sum, sum);
    return sum;
}

}  // namespace stria
