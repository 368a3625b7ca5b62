// A list that never changes once it is made: copies of what holds it share it.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace stria {

template <class T> class SharedList {
public:
    using value_type = T;

    SharedList() = default;
    SharedList(std::vector<T> list) : SharedList(std::make_shared<const std::vector<T>>(std::move(list))) {}
    SharedList(std::initializer_list<T> list) : SharedList(std::vector<T>(list)) {}
    /// Of something that is shared already, or of a part of it.
    explicit SharedList(std::shared_ptr<const std::vector<T>> list) : list_(std::move(list)), items_(*list_) {}

    [[nodiscard]] const T& operator[](std::size_t k) const { return items_[k]; }
    [[nodiscard]] std::size_t size() const { return items_.size(); }
    [[nodiscard]] bool empty() const { return items_.empty(); }
    [[nodiscard]] const T& front() const { return items_.front(); }
    [[nodiscard]] const T& back() const { return items_.back(); }
    [[nodiscard]] const T* data() const { return items_.data(); }
    [[nodiscard]] const T* begin() const { return items_.data(); }
    [[nodiscard]] const T* end() const { return items_.data() + items_.size(); }

    /// One of its own, to make another list of.
    [[nodiscard]] std::vector<T> copy() const { return {begin(), end()}; }

    friend bool operator==(const SharedList& a, const SharedList& b) {
        return a.list_ == b.list_ || std::equal(a.begin(), a.end(), b.begin(), b.end());
    }

private:
    std::shared_ptr<const std::vector<T>> list_;
    std::span<const T> items_;
};

}  // namespace stria
