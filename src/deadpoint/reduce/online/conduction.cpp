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

std::shared_ptr<const Conduction> Conductions::find(const TermWeights& weights)
{
    const std::scoped_lock lock(mutex_);
    const auto found = std::ranges::find(entries_, weights, &Entry::weights);
    if (found == entries_.end())
        return nullptr;
    std::rotate(entries_.begin(), found, found + 1);
    return entries_.front().conduction;
}

std::shared_ptr<const Conduction> Conductions::get(const TermWeights& weights,
                                                   const std::function<SymmetricMatrix()>& sum)
{
    if (auto found = find(weights))
        return found;
    auto result = std::make_shared<const Conduction>(sum());
    const std::scoped_lock lock(mutex_);
    entries_.push_front({weights, result});
    if (entries_.size() > most_kept)
        entries_.pop_back();
    return result;
}

std::size_t Conductions::count()
{
    const std::scoped_lock lock(mutex_);
    return entries_.size();
}

}  // namespace deadpoint::reduce
