#include "coupling/transport/remote_fine_scale.hpp"

#include <utility>

#include "common/error.hpp"
#include "coupling/transport/wire.hpp"

namespace stria::coupling {

namespace {

[[noreturn]] void throw_again(const Failure& failure) {
    if (failure.kind == Failure::Kind::Case) throw CaseError(failure.text);
    throw NumericalFailure(failure.text);
}

}  // namespace

RemoteFineScale::RemoteFineScale(Transport& transport, std::uint64_t case_digest) : transport_(transport) {
    const Hello own{.protocol = protocol_version, .case_digest = case_digest};
    send(Tag::Hello, pack(own));
    const Message reply = receive();
    expect(Tag::Hello, reply.tag);
    check_same(own, unpack<Hello>(reply.bytes));
}

RemoteFineScale::~RemoteFineScale() {
    try {
        begun_.reset();
        if (in_flight_) receive();  // an unread answer would keep the other side from reading on
        send(Tag::Stop, {});
    } catch (...) {  // it has ended already, or the end of the transport will tell it
    }
}

void RemoteFineScale::begin_set_patch(const Patch& patch) { begin(Tag::Patch, pack(patch)); }

void RemoteFineScale::set_patch(const Patch& patch) {
    if (begun_ != Tag::Patch) begin_set_patch(patch);
    answer(Tag::Done);
}

Eigen::MatrixXd RemoteFineScale::increments() {
    return unpack<Eigen::MatrixXd>(ask(Tag::Increments, {}, Tag::Increments).bytes);
}

void RemoteFineScale::request(const PatchDisplacement& displacement) { send(Tag::Displacement, pack(displacement)); }

PatchResponse RemoteFineScale::collect() {
    const Message message = answer(Tag::Response);
    PatchResponse response = unpack<PatchResponse>(message.bytes);
    if (response.same_tangent) {
        ++traffic_.tangents_not_sent;
        traffic_.bytes_not_sent += bytes_with_tangent_ - std::ssize(message.bytes);
    } else {
        bytes_with_tangent_ = std::ssize(message.bytes);
    }
    return response;
}

void RemoteFineScale::begin_commit(const Commit& what) { begin(Tag::Commit, pack(what)); }

StepReport RemoteFineScale::commit(const Commit& what) {
    if (begun_ != Tag::Commit) begin_commit(what);
    return unpack<StepReport>(answer(Tag::Report).bytes);
}

void RemoteFineScale::rollback() { ask(Tag::Rollback, {}, Tag::Done); }

ZoneState RemoteFineScale::state() { return unpack<ZoneState>(ask(Tag::State, {}, Tag::State).bytes); }

ZoneSnapshot RemoteFineScale::snapshot() { return unpack<ZoneSnapshot>(ask(Tag::Snapshot, {}, Tag::Snapshot).bytes); }

void RemoteFineScale::keep() { begin(Tag::Keep, {}); }

ZoneSnapshot RemoteFineScale::kept() { return unpack<ZoneSnapshot>(ask(Tag::Kept, {}, Tag::Snapshot).bytes); }

void RemoteFineScale::begin_restore(const Patch& patch, const ZoneSnapshot& snapshot) {
    begin(Tag::Restore, pack(Restore{patch, snapshot}));
}

void RemoteFineScale::restore(const Patch& patch, const ZoneSnapshot& snapshot) {
    if (begun_ != Tag::Restore) begin_restore(patch, snapshot);
    answer(Tag::Done);
}

/// The answers that nobody has waited for. That to a patch which nobody wants any more tells nothing.
void RemoteFineScale::hear_what_is_left() {
    if (begun_ == Tag::Patch) receive();
    if (begun_ == Tag::Keep) answer(Tag::Done);
}

void RemoteFineScale::send(Tag tag, std::vector<std::byte> bytes) {
    hear_what_is_left();
    require(!in_flight_, "one question in flight");
    ++traffic_.messages;
    traffic_.bytes += std::ssize(bytes);
    transport_.send(tag, std::move(bytes));
    in_flight_ = tag != Tag::Stop;
}

Message RemoteFineScale::receive() {
    require(in_flight_, "an answer is read once, after its question");
    in_flight_ = false;
    begun_.reset();
    Message message = transport_.receive();
    ++traffic_.messages;
    traffic_.bytes += std::ssize(message.bytes);
    return message;
}

Message RemoteFineScale::answer(Tag expected) {
    Message message = receive();
    if (message.tag == Tag::Failure) throw_again(unpack<Failure>(message.bytes));
    expect(expected, message.tag);
    return message;
}

void RemoteFineScale::begin(Tag question, std::vector<std::byte> bytes) {
    send(question, std::move(bytes));
    begun_ = question;
}

Message RemoteFineScale::ask(Tag question, std::vector<std::byte> bytes, Tag expected) {
    send(question, std::move(bytes));
    return answer(expected);
}

}  // namespace stria::coupling
