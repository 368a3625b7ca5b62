#include "coupling/transport/serve.hpp"

#include <utility>

#include "common/error.hpp"
#include "coupling/transport/wire.hpp"

namespace stria::coupling {

namespace {

Message reply(const Message& question, FineScale& fine) {
    switch (question.tag) {
    case Tag::Patch:
        fine.set_patch(unpack<Patch>(question.bytes));
        return {Tag::Done, {}};
    case Tag::Displacement:
        fine.request(unpack<PatchDisplacement>(question.bytes));
        return {Tag::Response, pack(fine.collect())};
    case Tag::Commit:
        return {Tag::Report, pack(fine.commit(unpack<Commit>(question.bytes)))};
    case Tag::Rollback:
        fine.rollback();
        return {Tag::Done, {}};
    case Tag::State:
        return {Tag::State, pack(fine.state())};
    case Tag::Snapshot:
        return {Tag::Snapshot, pack(fine.snapshot())};
    case Tag::Keep:
        fine.keep();
        return {Tag::Done, {}};
    case Tag::Kept:
        return {Tag::Snapshot, pack(fine.kept())};
    case Tag::Increments:
        return {Tag::Increments, pack(fine.increments())};
    case Tag::Restore: {
        const auto [patch, snapshot] = unpack<Restore>(question.bytes);
        fine.restore(patch, snapshot);
        return {Tag::Done, {}};
    }
    default:
        throw ComponentLost(std::string("the components lost step: no answer to ") + name(question.tag));
    }
}

Message reply_or_failure(const Message& question, FineScale& fine) {
    try {
        return reply(question, fine);
    } catch (const NumericalFailure& failure) {
        return {Tag::Failure, pack(Failure{Failure::Kind::Numerical, failure.what()})};
    } catch (const CaseError& error) {
        return {Tag::Failure, pack(Failure{Failure::Kind::Case, error.what()})};
    }
}

}  // namespace

void serve(Transport& transport, FineScale& fine, std::uint64_t case_digest) {
    const Hello own{.protocol = protocol_version, .case_digest = case_digest};
    const Message greeting = transport.receive();
    expect(Tag::Hello, greeting.tag);
    transport.send(Tag::Hello, pack(own));  // before any check: the other side shall see the difference as well
    check_same(own, unpack<Hello>(greeting.bytes));

    for (Message question = transport.receive(); question.tag != Tag::Stop; question = transport.receive()) {
        Message answer = reply_or_failure(question, fine);
        transport.send(answer.tag, std::move(answer.bytes));
    }
}

}  // namespace stria::coupling
