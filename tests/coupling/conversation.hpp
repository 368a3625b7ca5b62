// What every transport must keep, as a dialogue: both sides in one file. A side throws where the other breaks its word.
#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "common/error.hpp"
#include "coupling/transport/remote_fine_scale.hpp"
#include "coupling/transport/serve.hpp"
#include "coupling/transport/transport.hpp"
#include "tests/support/fake_fine_scale.hpp"
#include "tests/support/whole_tangent.hpp"

namespace stria::test {

using coupling::Tag;
using coupling::Transport;

inline void demand(bool kept, const char* promise) {
    if (!kept) throw std::runtime_error(promise);
}

/// Lengths about the places where transports change their ways: nothing, eager, rendezvous.
inline const std::vector<std::size_t> message_sizes{0, 1, 8, 4095, 4096, 65537, 5'000'000};

inline std::vector<std::byte> bytes_of_length(std::size_t size) {
    std::vector<std::byte> bytes(size);
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::byte>((i * 7 + size) % 251);
    return bytes;
}

inline void echo(Transport& transport) {
    for (std::size_t k = 0; k < message_sizes.size(); ++k) {
        const coupling::Message message = transport.receive();
        transport.send(message.tag, message.bytes);
    }
}

inline void hear_echo(Transport& transport) {
    for (const std::size_t size : message_sizes) {
        const std::vector<std::byte> bytes = bytes_of_length(size);
        transport.send(size % 2 ? Tag::Patch : Tag::Done, bytes);
        const coupling::Message back = transport.receive();
        demand(back.tag == (size % 2 ? Tag::Patch : Tag::Done), "a message keeps its tag");
        demand(back.bytes == bytes, "a message keeps its bytes");
    }
}

/// All sent before any is received: order is kept.
inline void send_many(Transport& transport) {
    for (std::uint8_t k = 0; k < 100; ++k) transport.send(Tag::State, std::vector{std::byte{k}});
}

inline void receive_many(Transport& transport) {
    for (std::uint8_t k = 0; k < 100; ++k)
        demand(transport.receive().bytes == std::vector{std::byte{k}}, "messages keep their order");
}

/// Both sides at once: nobody waits until what is sent has been taken.
inline void speak_first(Transport& transport) {
    const std::vector<std::byte> bytes = bytes_of_length(message_sizes.back());
    transport.send(Tag::State, bytes);
    demand(transport.receive().bytes == bytes, "who speaks first is heard");
}

/// The other end is destroyed right after the last word.
inline void expect_end(Transport& transport) {
    try {
        transport.receive();
    } catch (const ComponentLost&) {
        return;
    }
    throw std::runtime_error("an ended conversation throws ComponentLost");
}

inline coupling::Patch patch_of(int unknowns) {
    coupling::Patch patch;
    patch.mesh.nodes = {{0.0, 0.0}, {1.0, 0.0}};
    for (int i = 0; i < unknowns; ++i) patch.boundary.push_back(3 * i);
    return patch;
}

inline coupling::PatchDisplacement displacement_of(int iteration, int unknowns) {
    coupling::PatchDisplacement displacement{
        .iteration = iteration, .predictor = 0.5, .load_factor = 1.0, .boundary = {}};
    displacement.boundary = Eigen::VectorXd::LinSpaced(unknowns, -1.0 / 3.0, 0.1 * (iteration + 1)).array().sin();
    return displacement;
}

/// A short analysis; the same calls to two fine scales must give the same bits.
inline void compare(coupling::FineScale& one, coupling::FineScale& other, int unknowns) {
    one.set_patch(patch_of(unknowns));
    other.set_patch(patch_of(unknowns));
    for (int iteration = 0; iteration < 3; ++iteration) {
        one.request(displacement_of(iteration, unknowns));
        other.request(displacement_of(iteration, unknowns));
        const coupling::PatchResponse a = one.collect(), b = other.collect();
        demand(a.force == b.force && whole(a.tangent) == whole(b.tangent) && a.tangent.symmetry == b.tangent.symmetry,
               "forces and tangents keep their bits");
        demand(a.interior_force == b.interior_force && a.interior_displacement == b.interior_displacement,
               "scales keep their bits");
        demand(a.digest.yielding_points == b.digest.yielding_points, "digests are equal");
    }
    demand(one.commit({.reversal = true}).dissipation == other.commit({.reversal = true}).dissipation,
           "reports are equal");
    one.rollback();
    other.rollback();
    demand(one.state().displacement == other.state().displacement, "states are equal");
}

template <class Failure> void expect_failure(coupling::FineScale& remote, const std::string& text) {
    try {
        remote.rollback();
    } catch (const Failure& failure) {
        demand(failure.what() == text, "a failure keeps its text");
        return;
    }
    throw std::runtime_error("a failure keeps its type");
}

}  // namespace stria::test
