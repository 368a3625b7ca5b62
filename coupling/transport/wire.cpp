#include "coupling/transport/wire.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>

#include "common/error.hpp"
#include "common/index.hpp"
#include "coupling/transport/message_members.hpp"

namespace stria::coupling {

namespace {

static_assert(std::endian::native == std::endian::little && std::numeric_limits<double>::is_iec559);

template <class T>
concept Number = (std::is_arithmetic_v<T> || std::is_enum_v<T>)&&!std::is_same_v<T, bool>;

class Writer {
public:
    void operator()(std::string_view, const auto&... values) { (put(values), ...); }

    void lower_half(const Eigen::MatrixXd& a) {
        put(static_cast<std::uint32_t>(a.cols()));
        put_columns(a, true);
    }

    [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

private:
    template <class M> void put(const M& message) {
        if constexpr (Number<M>)
            put_raw(&message, 1);
        else
            members(*this, message);
    }

    template <class T> void put(const std::vector<T>& list) {
        put(std::uint64_t{list.size()});
        if constexpr (Number<T>)
            put_raw(list.data(), list.size());
        else
            for (const T& item : list) put(item);
    }

    template <class T> void put(const SharedList<T>& list) { put(list.copy()); }

    void put(const TermsOfNodes& terms) { put(terms.lists()); }

    template <class T, std::size_t n> void put(const std::array<T, n>& list) { put_raw(list.data(), n); }

    void put(bool flag) { put(static_cast<std::uint8_t>(flag)); }

    void put(const std::string& text) {
        put(std::uint64_t{text.size()});
        put_raw(text.data(), text.size());
    }

    void put(const Vec2& v) { put_raw(v.data(), 2); }

    void put(const Eigen::VectorXd& v) {
        put(static_cast<std::uint64_t>(v.size()));
        put_raw(v.data(), at(v.size()));
    }

    void put(const Eigen::MatrixXd& a) {
        put(static_cast<std::uint32_t>(a.rows()));
        put(static_cast<std::uint32_t>(a.cols()));
        put_columns(a, false);
    }

    void put_columns(const Eigen::MatrixXd& a, bool from_diagonal) {
        bytes_.reserve(bytes_.size() + at(a.size()) * sizeof(double));  // by far the largest part
        for (Eigen::Index j = 0; j < a.cols(); ++j) {
            const Eigen::Index first = from_diagonal ? j : 0;
            put_raw(a.col(j).data() + first, at(a.rows() - first));
        }
    }

    template <class T> void put_raw(const T* first, std::size_t count) {
        const auto* begin = reinterpret_cast<const std::byte*>(first);
        bytes_.insert(bytes_.end(), begin, begin + count * sizeof(T));
    }

    std::vector<std::byte> bytes_;
};

class Reader {
public:
    explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    void operator()(std::string_view, auto&... values) { (get(values), ...); }

    void lower_half(Eigen::MatrixXd& a) {
        std::uint32_t order = 0;
        get(order);
        make_room(a, order, order, order * (order + std::uint64_t{1}) / 2);
        get_columns(a, true);
    }

    [[nodiscard]] bool finished() const { return bytes_.empty(); }

private:
    template <class M> void get(M& message) {
        if constexpr (Number<M>)
            get_raw(&message, 1);
        else
            members(*this, message);
    }

    template <class T> void get(std::vector<T>& list) {
        list.resize(get_size(Number<T> ? sizeof(T) : 1));
        if constexpr (Number<T>)
            get_raw(list.data(), list.size());
        else
            for (T& item : list) get(item);
    }

    template <class T> void get(SharedList<T>& list) {
        std::vector<T> own;
        get(own);
        list = std::move(own);
    }

    void get(TermsOfNodes& terms) {
        std::vector<std::vector<Term>> lists;
        get(lists);
        terms = lists;
    }

    template <class T, std::size_t n> void get(std::array<T, n>& list) { get_raw(list.data(), n); }

    void get(bool& flag) {
        std::uint8_t byte = 0;
        get(byte);
        flag = byte != 0;
    }

    void get(std::string& text) {
        text.resize(get_size(1));
        get_raw(text.data(), text.size());
    }

    void get(Vec2& v) { get_raw(v.data(), 2); }

    void get(Eigen::VectorXd& v) {
        v.resize(static_cast<Eigen::Index>(get_size(sizeof(double))));
        get_raw(v.data(), at(v.size()));
    }

    void get(Eigen::MatrixXd& a) {
        std::uint32_t rows = 0, cols = 0;
        get(rows);
        get(cols);
        make_room(a, rows, cols, std::uint64_t{rows} * cols);
        get_columns(a, false);
    }

    void make_room(Eigen::MatrixXd& a, std::uint32_t rows, std::uint32_t cols, std::uint64_t numbers) {
        if (numbers > bytes_.size() / sizeof(double)) throw_truncated();
        a.resize(rows, cols);
    }

    void get_columns(Eigen::MatrixXd& a, bool from_diagonal) {
        for (Eigen::Index j = 0; j < a.cols(); ++j) {
            const Eigen::Index first = from_diagonal ? j : 0;
            get_raw(a.col(j).data() + first, at(a.rows() - first));
        }
    }

    /// A length that the rest of the message can hold: a broken one must not ask for all memory.
    std::size_t get_size(std::size_t bytes_each) {
        std::uint64_t size = 0;
        get(size);
        if (size > bytes_.size() / bytes_each) throw_truncated();
        return at(size);
    }

    template <class T> void get_raw(T* first, std::size_t count) {
        const std::size_t size = count * sizeof(T);
        if (size > bytes_.size()) throw_truncated();
        if (size > 0) std::memcpy(first, bytes_.data(), size);
        bytes_ = bytes_.subspan(size);
    }

    [[noreturn]] static void throw_truncated() { throw ComponentLost("a message between the components is truncated"); }

    std::span<const std::byte> bytes_;
};

}  // namespace

template <class M> std::vector<std::byte> pack(const M& message) {
    Writer writer;
    writer("", message);
    return writer.take();
}

template <class M> M unpack(std::span<const std::byte> bytes) {
    Reader reader(bytes);
    M message;
    reader("", message);
    if (!reader.finished()) throw ComponentLost("a message between the components is longer than its contents");
    return message;
}

template std::vector<std::byte> pack(const Hello&);
template std::vector<std::byte> pack(const Failure&);
template std::vector<std::byte> pack(const Commit&);
template std::vector<std::byte> pack(const Patch&);
template std::vector<std::byte> pack(const PatchDisplacement&);
template std::vector<std::byte> pack(const PatchResponse&);
template std::vector<std::byte> pack(const StepReport&);
template std::vector<std::byte> pack(const ZoneState&);
template std::vector<std::byte> pack(const ZoneSnapshot&);
template std::vector<std::byte> pack(const Restore&);
template std::vector<std::byte> pack(const Eigen::MatrixXd&);
template std::vector<std::byte> pack(const std::vector<MultiplierSnapshot>&);
template std::vector<std::byte> pack(const std::vector<FrozenTip>&);
template std::vector<std::byte> pack(const std::vector<NearestContact>&);

template Hello unpack(std::span<const std::byte>);
template Failure unpack(std::span<const std::byte>);
template Commit unpack(std::span<const std::byte>);
template Patch unpack(std::span<const std::byte>);
template PatchDisplacement unpack(std::span<const std::byte>);
template PatchResponse unpack(std::span<const std::byte>);
template StepReport unpack(std::span<const std::byte>);
template ZoneState unpack(std::span<const std::byte>);
template ZoneSnapshot unpack(std::span<const std::byte>);
template Eigen::MatrixXd unpack(std::span<const std::byte>);
template Restore unpack(std::span<const std::byte>);
template std::vector<MultiplierSnapshot> unpack(std::span<const std::byte>);
template std::vector<FrozenTip> unpack(std::span<const std::byte>);
template std::vector<NearestContact> unpack(std::span<const std::byte>);

}  // namespace stria::coupling
