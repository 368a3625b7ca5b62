// Values as groups of an HDF5 file, and back: writing and reading walk through the same list of members
// (common/members.hpp).
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

#include "common/index.hpp"
#include "common/index_set.hpp"
#include "common/io/hdf5.hpp"
#include "common/members.hpp"

namespace stria::hdf5 {

namespace detail {

template <class T> inline constexpr bool is_vector = false;
template <class T> inline constexpr bool is_vector<std::vector<T>> = true;

template <class T> inline constexpr bool is_index_set = false;
template <class Kind> inline constexpr bool is_index_set<IndexSet<Kind>> = true;

/// What a scalar or an entry of a list is stored as.
template <class T> struct Stored {
    using Type = std::conditional_t<std::is_floating_point_v<T>, double,
                                    std::conditional_t<sizeof(T) == 1, std::int8_t, std::int64_t>>;
};
template <Storable T> struct Stored<T> { using Type = T; };

template <class T>
concept Plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

/// Of plain members, or of members that are records.
template <class T>
concept Record = std::is_class_v<T> && std::is_trivially_copyable_v<T>;

/// A list for each member of a record.
template <class... T> using Columns = std::tuple<std::vector<T>...>;

/// Of which a list is kept as bytes: bytes_of(list) and from_bytes(bytes, list) stand beside the type.
template <class T>
concept KeptAsBytes = requires(const std::vector<T>& list) {
    bytes_of(list);
};

}  // namespace detail

/// Scalars become attributes; lists of numbers, vectors, texts and index sets datasets; lists of vectors of one length
/// datasets of two dimensions; lists of records tables, a dataset for each member; everything else groups. Throws
/// std::runtime_error as Group does.
class Saver {
public:
    explicit Saver(Group group) : group_(std::move(group)) {}

    /// `names`: "a, b", of as many values.
    template <class... T> void operator()(std::string_view names, const T&... values) {
        MemberNames list(names);
        (put(std::string(list.next()), values), ...);
    }

private:
    template <class T> void put(const std::string& name, const T& value) {
        using detail::Stored;
        if constexpr (detail::Plain<T>) {
            using S = typename Stored<T>::Type;
            group_.write_attribute<S>(name, std::array{static_cast<S>(value)});
        } else if constexpr (std::is_same_v<T, Eigen::VectorXd>) {
            group_.write<double>(name, std::span(value.data(), at(value.size())));
        } else if constexpr (std::is_same_v<T, std::string>) {
            list(name, std::vector<char>(value.begin(), value.end()));
        } else if constexpr (detail::is_index_set<T>) {
            list(name, value.flags());
        } else if constexpr (detail::is_vector<T>) {
            list(name, value);
        } else {
            Saver inner(group_.create_group(name));
            members(inner, value);
        }
    }

    template <class T> void list(const std::string& name, const std::vector<T>& values) {
        if constexpr (detail::Plain<T>) {
            using S = typename detail::Stored<T>::Type;
            std::vector<S> stored;
            stored.reserve(values.size());
            for (const T value : values) stored.push_back(static_cast<S>(value));
            group_.write<S>(name, stored);
        } else if constexpr (std::is_same_v<T, Eigen::VectorXd>) {
            const std::size_t length = values.empty() ? 0 : at(values.front().size());
            std::vector<double> stored;
            stored.reserve(values.size() * length);
            for (const T& value : values) stored.insert(stored.end(), value.begin(), value.end());
            group_.write<double>(name, stored, {values.size(), length});
        } else if constexpr (detail::KeptAsBytes<T>) {
            list(name, bytes_of(values));
        } else if constexpr (detail::Record<T>) {
            table(name, values);
        } else {
            Saver inner(group_.create_group(name));
            inner.put("count", values.size());
            for (std::size_t k = 0; k < values.size(); ++k) inner.put(std::to_string(k), values[k]);
        }
    }

    /// As a group for each record the blocks of a spectrum took most of a run (docs/performance.md, checkpoints).
    template <class T> void table(const std::string& name, const std::vector<T>& rows) {
        Saver inner(group_.create_group(name));
        inner.put("count", rows.size());
        const auto save = [&](std::string_view names, const auto&... of_row) {
            detail::Columns<std::remove_cvref_t<decltype(of_row)>...> columns;
            const auto take = [&](std::string_view, const auto&... value) {
                std::apply([&](auto&... column) { (column.push_back(value), ...); }, columns);
            };
            for (const T& row : rows) members(take, row);
            std::apply([&](const auto&... column) { inner(names, column...); }, columns);
        };
        const T any{};
        members(save, any);
    }

    Group group_;
};

class Loader {
public:
    explicit Loader(Group group) : group_(std::move(group)) {}

    template <class... T> void operator()(std::string_view names, T&... values) {
        MemberNames list(names);
        (get(std::string(list.next()), values), ...);
    }

private:
    template <class T> void get(const std::string& name, T& value) {
        if constexpr (detail::Plain<T>) {
            value = static_cast<T>(group_.read_attribute<typename detail::Stored<T>::Type>(name).at(0));
        } else if constexpr (std::is_same_v<T, Eigen::VectorXd>) {
            const std::vector<double> stored = group_.read<double>(name);
            value = Eigen::Map<const Eigen::VectorXd>(stored.data(), std::ssize(stored));
        } else if constexpr (std::is_same_v<T, std::string>) {
            std::vector<char> letters;
            list(name, letters);
            value.assign(letters.begin(), letters.end());
        } else if constexpr (detail::is_index_set<T>) {
            std::vector<char> flags;
            list(name, flags);
            value = T::of_flags(std::move(flags));
        } else if constexpr (detail::is_vector<T>) {
            list(name, value);
        } else {
            Loader inner(group_.group(name));
            members(inner, value);
        }
    }

    template <class T> void list(const std::string& name, std::vector<T>& values) {
        if constexpr (detail::Plain<T>) {
            const auto stored = group_.read<typename detail::Stored<T>::Type>(name);
            values.clear();
            values.reserve(stored.size());
            for (const auto value : stored) values.push_back(static_cast<T>(value));
        } else if constexpr (std::is_same_v<T, Eigen::VectorXd>) {
            const std::vector<double> stored = group_.read<double>(name);
            const std::vector<std::size_t> shape = group_.shape(name);
            const auto length = static_cast<Eigen::Index>(shape.at(1));
            values.clear();
            for (std::size_t k = 0; k < shape[0]; ++k)
                values.emplace_back(Eigen::Map<const Eigen::VectorXd>(stored.data() + k * shape[1], length));
        } else if constexpr (detail::KeptAsBytes<T>) {
            std::vector<std::byte> bytes;
            list(name, bytes);
            from_bytes(bytes, values);
        } else if constexpr (detail::Record<T>) {
            table(name, values);
        } else {
            Loader inner(group_.group(name));
            std::size_t count = 0;
            inner.get("count", count);
            values.resize(count);
            for (std::size_t k = 0; k < count; ++k) inner.get(std::to_string(k), values[k]);
        }
    }

    template <class T> void table(const std::string& name, std::vector<T>& rows) {
        Loader inner(group_.group(name));
        std::size_t count = 0;
        inner.get("count", count);
        rows.resize(count);
        const auto load = [&](std::string_view names, const auto&... of_row) {
            detail::Columns<std::remove_cvref_t<decltype(of_row)>...> columns;
            std::apply([&](auto&... column) { inner(names, column...); }, columns);
            for (std::size_t k = 0; k < count; ++k) {
                const auto put = [&](std::string_view, auto&... value) {
                    std::apply([&](const auto&... column) { ((value = column.at(k)), ...); }, columns);
                };
                members(put, rows[k]);
            }
        };
        const T any{};
        members(load, any);
    }

    Group group_;
};

}  // namespace stria::hdf5
