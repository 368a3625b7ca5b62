#include "common/io/hdf5.hpp"

#include <hdf5.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "common/index.hpp"
#include "common/io/whole_file.hpp"

namespace stria::hdf5 {
namespace {

template <Storable T> hid_t memory_type() {
    if constexpr (std::same_as<T, double>) return H5T_NATIVE_DOUBLE;
    if constexpr (std::same_as<T, std::int32_t>) return H5T_NATIVE_INT32;
    if constexpr (std::same_as<T, std::int64_t>) return H5T_NATIVE_INT64;
    if constexpr (std::same_as<T, std::uint64_t>) return H5T_NATIVE_UINT64;
    if constexpr (std::same_as<T, std::int8_t>) return H5T_NATIVE_INT8;
    if constexpr (std::same_as<T, std::uint8_t>) return H5T_NATIVE_UINT8;
}

[[noreturn]] void fail(const char* what, const std::string& name) {
    throw std::runtime_error(std::string("HDF5: cannot ") + what + " \"" + name + "\"");
}

void check(herr_t result, const char* what, const std::string& name) {
    if (result < 0) fail(what, name);
}

}  // namespace

/// An identifier of the library that closes itself.
struct Group::Handle {
    hid_t id;
    herr_t (*close)(hid_t);
    std::shared_ptr<const Handle> parent;  // a file outlives its groups: it is closed after them

    Handle(hid_t opened, herr_t (*closer)(hid_t), const char* what, const std::string& name,
           std::shared_ptr<const Handle> owner = nullptr)
        : id(opened), close(closer), parent(std::move(owner)) {
        if (id < 0) fail(what, name);
    }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    Handle(Handle&&) = delete;
    Handle& operator=(Handle&&) = delete;
    ~Handle() { close(id); }

    static Handle vector_space(std::size_t count, const std::string& name) {
        const hsize_t extent = count;
        return {H5Screate_simple(1, &extent, nullptr), H5Sclose, "describe", name};
    }
    static Handle space(const std::vector<std::size_t>& shape, const std::string& name) {
        const std::vector<hsize_t> extents(shape.begin(), shape.end());
        return {H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr), H5Sclose, "describe",
                name};
    }
    static Handle text_type(std::size_t length, const std::string& name) {
        Handle type(H5Tcopy(H5T_C_S1), H5Tclose, "describe", name);
        check(H5Tset_size(type.id, std::max<std::size_t>(length, 1)), "describe", name);
        check(H5Tset_strpad(type.id, H5T_STR_NULLPAD), "describe", name);
        return {H5Tcopy(type.id), H5Tclose, "describe", name};
    }
    /// Without the time of day: the same values make the same file.
    static Handle timeless(const std::string& name) {
        Handle properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose, "describe", name);
        check(H5Pset_obj_track_times(properties.id, false), "describe", name);
        return {H5Pcopy(properties.id), H5Pclose, "describe", name};
    }
    static Handle in_memory(const std::string& name) {
        Handle properties(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "describe", name);
        check(H5Pset_fapl_core(properties.id, std::size_t{1} << 20U, false), "describe", name);
        return {H5Pcopy(properties.id), H5Pclose, "describe", name};
    }
    /// The bytes of an open file.
    [[nodiscard]] std::string image(const std::string& name) const {
        const ssize_t size = H5Fget_file_image(id, nullptr, 0);
        if (size < 0) fail("write", name);
        std::string bytes(static_cast<std::size_t>(size), '\0');
        if (H5Fget_file_image(id, bytes.data(), bytes.size()) != size) fail("write", name);
        return bytes;
    }
    static Handle dataset(const Handle& group, const std::string& name) {
        return {H5Dopen2(group.id, name.c_str(), H5P_DEFAULT), H5Dclose, "open dataset", name};
    }
    static Handle attribute(const Handle& group, const std::string& name) {
        return {H5Aopen(group.id, name.c_str(), H5P_DEFAULT), H5Aclose, "open attribute", name};
    }
};

Group Group::create_group(const std::string& name) {
    return Group(
        std::make_shared<const Handle>(H5Gcreate2(handle_->id, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                                       H5Gclose, "create group", name, handle_));
}

Group Group::group(const std::string& name) const {
    return Group(std::make_shared<const Handle>(H5Gopen2(handle_->id, name.c_str(), H5P_DEFAULT), H5Gclose,
                                                "open group", name, handle_));
}

bool Group::contains(const std::string& name) const {
    return H5Lexists(handle_->id, name.c_str(), H5P_DEFAULT) > 0 || H5Aexists(handle_->id, name.c_str()) > 0;
}

template <Storable T>
void Group::write(const std::string& name, std::span<const T> values, const std::vector<std::size_t>& shape) {
    const std::size_t size = std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
    if (!shape.empty() && size != values.size()) fail("shape", name);
    const Handle space = shape.empty() ? Handle::vector_space(values.size(), name) : Handle::space(shape, name);
    const Handle properties = Handle::timeless(name);
    const Handle dataset(
        H5Dcreate2(handle_->id, name.c_str(), memory_type<T>(), space.id, H5P_DEFAULT, properties.id, H5P_DEFAULT),
        H5Dclose, "create dataset", name);
    if (values.empty()) return;
    check(H5Dwrite(dataset.id, memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "write dataset", name);
}

template <Storable T> std::vector<T> Group::read(const std::string& name) const {
    const Handle dataset = Handle::dataset(*handle_, name);
    const Handle space(H5Dget_space(dataset.id), H5Sclose, "describe", name);
    std::vector<T> values(at(H5Sget_simple_extent_npoints(space.id)));
    if (values.empty()) return values;
    check(H5Dread(dataset.id, memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), "read dataset", name);
    return values;
}

std::vector<std::size_t> Group::shape(const std::string& name) const {
    const Handle dataset = Handle::dataset(*handle_, name);
    const Handle space(H5Dget_space(dataset.id), H5Sclose, "describe", name);
    std::vector<hsize_t> extents(at(H5Sget_simple_extent_ndims(space.id)));
    check(H5Sget_simple_extent_dims(space.id, extents.data(), nullptr), "describe", name);
    return {extents.begin(), extents.end()};
}

template <Storable T> void Group::write_attribute(const std::string& name, std::span<const T> values) {
    const Handle space = Handle::vector_space(values.size(), name);
    const Handle attribute(H5Acreate2(handle_->id, name.c_str(), memory_type<T>(), space.id, H5P_DEFAULT, H5P_DEFAULT),
                           H5Aclose, "create attribute", name);
    if (!values.empty()) check(H5Awrite(attribute.id, memory_type<T>(), values.data()), "write attribute", name);
}

template <Storable T> std::vector<T> Group::read_attribute(const std::string& name) const {
    const Handle attribute = Handle::attribute(*handle_, name);
    const Handle space(H5Aget_space(attribute.id), H5Sclose, "describe", name);
    std::vector<T> values(at(H5Sget_simple_extent_npoints(space.id)));
    if (!values.empty()) check(H5Aread(attribute.id, memory_type<T>(), values.data()), "read attribute", name);
    return values;
}

void Group::write_text(const std::string& name, std::string_view text) {
    const Handle type = Handle::text_type(text.size(), name);
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose, "describe", name);
    const Handle attribute(H5Acreate2(handle_->id, name.c_str(), type.id, space.id, H5P_DEFAULT, H5P_DEFAULT), H5Aclose,
                           "create attribute", name);
    const std::string padded = text.empty() ? std::string(1, '\0') : std::string(text);
    check(H5Awrite(attribute.id, type.id, padded.data()), "write attribute", name);
}

std::string Group::read_text(const std::string& name) const {
    const Handle attribute = Handle::attribute(*handle_, name);
    const Handle stored(H5Aget_type(attribute.id), H5Tclose, "describe", name);
    std::string text(H5Tget_size(stored.id), '\0');
    const Handle type = Handle::text_type(text.size(), name);
    check(H5Aread(attribute.id, type.id, text.data()), "read attribute", name);
    return text.substr(0, text.find('\0'));
}

std::string image_of(const std::function<void(Group&)>& fill) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // failures are exceptions here, not text on stderr
    const std::string name = "image";
    const Group::Handle in_memory = Group::Handle::in_memory(name);
    Group root(std::make_shared<const Group::Handle>(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, in_memory.id),
                                                     H5Fclose, "create", name));
    fill(root);
    check(H5Fflush(root.handle_->id, H5F_SCOPE_GLOBAL), "write", name);
    return root.handle_->image(name);
}

void write_file(const std::filesystem::path& path, const std::function<void(Group&)>& fill) {
    write_whole_text(path, image_of(fill));
}

Group read_file(const std::filesystem::path& path) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    return Group(std::make_shared<const Group::Handle>(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose,
                                                       "open", path.string()));
}

#define STRIA_STORABLE(T)                                                                                              \
    template void Group::write<T>(const std::string&, std::span<const T>, const std::vector<std::size_t>&);            \
    template std::vector<T> Group::read<T>(const std::string&) const;                                                  \
    template void Group::write_attribute<T>(const std::string&, std::span<const T>);                                   \
    template std::vector<T> Group::read_attribute<T>(const std::string&) const;
STRIA_STORABLE(double)
STRIA_STORABLE(std::int32_t)
STRIA_STORABLE(std::int64_t)
STRIA_STORABLE(std::uint64_t)
STRIA_STORABLE(std::int8_t)
STRIA_STORABLE(std::uint8_t)
#undef STRIA_STORABLE

}  // namespace stria::hdf5
