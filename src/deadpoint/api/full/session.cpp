#include "deadpoint/session.hpp"

#include "deadpoint/fem/algebra/session.hpp"

namespace deadpoint {

struct Session::Implementation {
    Implementation() = default;
    explicit Implementation(int communicator) : session(fem::FortranCommunicator{communicator}) {}
    fem::Session session;
};

Session::Session() : implementation_(std::make_unique<Implementation>()) {}
Session::Session(int communicator) : implementation_(std::make_unique<Implementation>(communicator)) {}
Session::~Session() = default;
int Session::rank() const noexcept { return implementation_->session.rank(); }
int Session::size() const noexcept { return implementation_->session.size(); }

}  // namespace deadpoint
