#include "deadpoint/reduce/online/conduction.hpp"

#include <algorithm>
#include <utility>

namespace deadpoint::reduce {
namespace {

constexpr std::size_t most_kept = 4;  // segments of work and pause on two threads

}  // namespace

std::shared_ptr<const TridiagonalForm> Conduction::form() const
{
    std::call_once(once_, [&] { form_ = std::make_shared<const TridiagonalForm>(matrix_); });
    return form_;
}

std::shared_ptr<const Conduction> Conductions::find(const std::vector<SymmetricMatrix::Term>& terms)
{
    const std::scoped_lock lock(mutex_);
    const auto found = std::ranges::find(entries_, terms, &Entry::terms);
    if (found == entries_.end())
        return nullptr;
    std::rotate(entries_.begin(), found, found + 1);
    return entries_.front().conduction;
}

std::shared_ptr<const Conduction> Conductions::sum(const SymmetricMatrix& start,
                                                   const std::vector<SymmetricMatrix::Term>& terms)
{
    if (auto found = find(terms))
        return found;
    auto result = std::make_shared<const Conduction>(start.plus(terms));
    const std::scoped_lock lock(mutex_);
    entries_.push_front({terms, result});
    if (entries_.size() > most_kept)
        entries_.pop_back();
    return result;
}

}  // namespace deadpoint::reduce
