#include "deadpoint/press/laws/friction.hpp"

#include "deadpoint/casefile/describe/case.hpp"
#include "deadpoint/casefile/syntax/case_bytes.hpp"
#include "deadpoint/core/mistakes.hpp"
#include "deadpoint/core/units.hpp"
#include "deadpoint/exchange/cycle.hpp"
#include "deadpoint/exchange/linkage.hpp"
#include "deadpoint/exchange/machine.hpp"
#include "deadpoint/press/laws/friction_physics.hpp"
#include "deadpoint/press/laws/viscosity.hpp"
#include "deadpoint/press/loads/kept_friction.hpp"
#include "deadpoint/press/loads/loads.hpp"
#include "deadpoint/press/loads/loads_cache.hpp"
#include "deadpoint/press/result/friction_summary.hpp"
#include "deadpoint/press/result/loads_result.hpp"
#include "deadpoint/press/translate/loads.hpp"
#include "deadpoint/tribology/friction/calibrated.hpp"
#include "deadpoint/tribology/friction/heat_law.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace deadpoint::press {
namespace {

using tribology::Duty;

constexpr double reporting_temperature = 313.15;  // 40 degC
constexpr double negligible = 1e-6;               // share of the largest joint force below which a joint is unloaded

std::string original_name(const LoadsResult& loads, std::size_t joint)
{
    const auto& name = loads.linkage.joints[joint].name;
    return loads.images[joint] ? name.substr(0, name.size() - 1) : name;
}

// Duty of a joint of the linkage; that of a slide is the sum of its faces.
Duty joint_duty(const LoadsResult& loads, std::size_t index, const casefile::Joint& joint)
{
    const auto& cycle = loads.history.joints[index];
    if (loads.linkage.joints[index].kind == LinkageJoint::Kind::slide)
        return tribology::guide_duty(loads.history, cycle, describe_guide(joint));
    return tribology::duty_of(loads.history, cycle);
}

// Bearings or bushes that share the joint.
std::size_t element_count(const casefile::Joint& joint) { return std::max<std::size_t>(1, joint.elements.size()); }

double load_duty_of(const std::vector<RubbingJoint>& joints, tribology::FrictionKind kind)
{
    const double exponent = kind == tribology::FrictionKind::rolling ? tribology::rolling_load_exponent : 1.0;
    double sum = 0;
    for (const auto& joint : joints)
        for (const auto& duty : joint.duties)
            sum += tribology::duty_mean(duty, exponent, 1);
    return sum;
}

double largest_joint_force(const LoadsResult& loads)
{
    double largest = 0;
    for (const auto& joint : loads.history.joints)
        for (const auto& force : joint.force)
            largest = std::max(largest, norm(force));
    return largest;
}

bool carries_nothing(const std::vector<RubbingJoint>& joints, const LoadsResult& loads)
{
    const double limit = negligible * largest_joint_force(loads);
    const auto unloaded = [&](const Duty& duty) { return tribology::peak_force(duty) <= limit; };
    return std::ranges::all_of(joints,
                               [&](const RubbingJoint& joint) { return std::ranges::all_of(joint.duties, unloaded); });
}

FrictionPower friction_power(const FrictionSummary& summary, const PowerBalance& balance, double temperature,
                             double period)
{
    FrictionPower power;
    power.temperature = temperature;
    for (const auto& row : summary.rows)
        power.friction += row.heat(temperature).value;
    power.motor = balance.process + power.friction;
    power.torque = power.friction * period / (2 * std::numbers::pi);
    if (balance.rated > 0)
        power.share_of_motor = power.motor / balance.rated;
    return power;
}

PowerBalance power_balance(const casefile::Case& input, const FrictionSummary& summary, const LoadsResult& loads)
{
    const auto& turn = loads.history;
    const auto weight = tribology::turn_weights(turn.time, turn.period);
    PowerBalance balance;
    balance.drive = loads.drive.mean_power;
    for (std::size_t i = 0; i < weight.size(); ++i) {
        balance.process -= weight[i] * turn.process_force[i] * turn.slide_speed[i];
        balance.swing += weight[i] * std::abs(turn.drive_torque[i] * turn.speed[i]);
    }
    if (input.crankshaft && input.crankshaft->belt)
        balance.rated = input.crankshaft->belt->power;
    balance.at.push_back(friction_power(summary, balance, input.machine.initial_temperature, turn.period));
    if (input.machine.initial_temperature != reporting_temperature)
        balance.at.push_back(friction_power(summary, balance, reporting_temperature, turn.period));
    return balance;
}

std::string operating_point(double speed, double force)
{
    return fmt::format("at {:.4g} rpm and {:.4g} kN", speed * 30 / std::numbers::pi, force / 1e3);
}

std::string unloaded_text(const FrictionHeat& row)
{
    return fmt::format(
        "friction.{}: its joints carry no load at the reference (the linkage is balanced about them), "
        "so its load part changes with the speed only; state a preload, or an offset of the process force",
        row.row);
}

std::vector<std::string> power_warnings(const FrictionSummary& summary)
{
    std::vector<std::string> warnings;
    if (!summary.balance)
        return warnings;
    const auto& balance = *summary.balance;
    const auto place = operating_point(summary.speed, summary.force);
    if (balance.mismatch() > power_tolerance)
        warnings.push_back(fmt::format("{}: without friction the drive gives {:.4g} W and the process takes {:.4g} W; "
                                       "raise mechanism.positions",
                                       place, balance.drive, balance.process));
    for (const auto& power : balance.at)
        if (power.share_of_motor && *power.share_of_motor > 1)
            warnings.push_back(fmt::format("{}: process and friction with all joints at {:.0f} degC take {:.4g} W, but "
                                           "crankshaft.belt.power is {:.4g} W; check the friction laws and the motor",
                                           place, power.temperature - zero_celsius, power.motor, balance.rated));
    return warnings;
}

bool is_calibrated(const casefile::Friction& friction)
{
    return std::holds_alternative<casefile::CalibratedFriction>(friction.law);
}

}  // namespace

/// A calibrated law at an operating point.
struct CalibratedAt {
    tribology::CalibratedFriction law;
    tribology::DutyRatio duty;
    std::optional<double> load_ratio;  ///< of a law with a reference force, in a press that runs
    bool unloaded = false;             ///< such a law, whose joints carry no load at the reference
};

FrictionLaws::FrictionLaws(const casefile::Case& input, const Machine* machine, const LoadsResult* known,
                           LoadsCache* shared)
    : input_(input), machine_(machine), known_(known), shared_(shared),
      kept_(shared && known ? shared->friction_at(*known) : std::make_shared<KeptFriction>())
{
    if (known_)
        for (const auto& warning : known_->warnings)
            heard_.insert(warning.about);
}
FrictionLaws::~FrictionLaws() = default;

void FrictionLaws::keep_warnings(const LoadsResult& loads, bool at_reference)
{
    const bool first = !known_ && computed_.size() == 1;
    for (const auto& warning : loads.warnings) {
        if (!heard_.insert(warning.about).second)
            continue;
        warnings_.push_back(first ? warning.text
                                  : fmt::format("{}{}: {}", operating_point(loads.speed, loads.force),
                                                at_reference ? ", a reference of friction" : "", warning.text));
    }
}

const LoadsResult& FrictionLaws::compute(const LoadsKey& key, const std::function<casefile::Case()>& input)
{
    auto& slot = computed_[key];
    if (!slot) {
        slot = *kept_->loads.get(key, [&] {
            const auto changed = input();
            if (!has_loads(changed))
                throw InputError(
                    "its heat follows the loads of the linkage, which the case does not describe\n  help: name "
                    "the driver's joint with `driver = true` and the body that carries the tool with "
                    "`mechanism.slide_body`");
            return shared_
                       ? shared_->get(changed, machine_, 0, Vibration::left_out)
                       : std::make_shared<const LoadsResult>(compute_loads(changed, machine_, 0, Vibration::left_out));
        });
        keep_warnings(*slot, key.at_reference);
    }
    return *slot;
}

const LoadsResult& FrictionLaws::loads(const casefile::Segment& segment)
{
    if (known_ && known_->speed == segment.speed && known_->force == segment.force)
        return *known_;
    return compute({{segment.speed, segment.force}, false, 0}, [&] {
        auto input = input_;
        input.operation = {segment};
        return input;
    });
}

LoadsKey FrictionLaws::reference_key(const casefile::CalibratedFriction& friction) const
{
    using Model = casefile::Crankshaft::Model;
    const OperatingPoint at{friction.reference_speed, *friction.reference_force};
    if (!input_.crankshaft || (input_.crankshaft->model == Model::flexible && !friction.reference_stiffness))
        return {at, false, 0};
    return {at, true, friction.reference_stiffness.value_or(0)};
}

const LoadsResult& FrictionLaws::reference(const casefile::CalibratedFriction& friction)
{
    casefile::Segment segment;
    segment.speed = friction.reference_speed;
    segment.force = *friction.reference_force;
    const auto key = reference_key(friction);
    if (!key.at_reference)
        return loads(segment);
    return compute(key, [&] {
        auto input = input_;
        input.operation = {segment};
        input.crankshaft->model = casefile::Crankshaft::Model::flexible;
        if (friction.reference_stiffness)
            for (auto& bearing : input.crankshaft->bearings)
                bearing.stiffness = {{{*friction.reference_stiffness, 0}, {0, *friction.reference_stiffness}}};
        return input;
    });
}

std::vector<RubbingJoint> FrictionLaws::rubbing_joints(const std::string& row, const LoadsResult& loads) const
{
    const auto measure = input_.friction.at(row).load_measure;
    std::vector<RubbingJoint> result;
    for (std::size_t j = 0; j < loads.linkage.joints.size(); ++j) {
        const auto name = original_name(loads, j);
        const auto& joint = input_.joints.at(name);
        if (joint.friction != row)
            continue;
        RubbingJoint rubbing{name, &joint, {}};
        if (joint.driver && loads.crankshaft) {
            for (const auto& bearing : loads.crankshaft->cycle().bearings)
                rubbing.duties.push_back(tribology::measured(tribology::duty_of(bearing, loads.speed), measure));
        } else {
            const auto duty = tribology::measured(joint_duty(loads, j, joint), measure);
            const auto count = element_count(joint);
            rubbing.duties.assign(count, tribology::shared(duty, 1.0 / static_cast<double>(count)));
        }
        result.push_back(std::move(rubbing));
    }
    return result;
}

// All that the heat of a law follows from, besides loads and its scale.
std::string FrictionLaws::inputs_of(const std::string& row, casefile::Friction friction) const
{
    casefile::Case part;
    if (!friction.lubricant.empty())
        part.lubricants.emplace(friction.lubricant, input_.lubricants.at(friction.lubricant));
    friction.scale = 1;
    part.friction.emplace(row, std::move(friction));
    for (const auto& [name, joint] : input_.joints) {
        if (joint.friction != row)
            continue;
        auto& own = part.joints.emplace(name, joint).first->second;
        own.oil_temperature = casefile::Joint{}.oil_temperature;
        own.clearance.reset();
        for (auto& interface : own.interfaces) {
            interface.conductance = {};
            interface.oil = 0;
            interface.heat_share = 1;
        }
    }
    return casefile::case_bytes(std::move(part));
}

LoadDuty FrictionLaws::load_duty(const std::string& row, const std::string& inputs, const LoadsKey& key,
                                 const LoadsResult& loads)
{
    const auto kept = shared_ && &loads != known_ ? shared_->friction_at(loads) : kept_;
    return *kept->duties.get({inputs, key}, [&] {
        const auto kind = std::get<casefile::CalibratedFriction>(input_.friction.at(row).law).kind;
        const auto joints = rubbing_joints(row, loads);
        return LoadDuty{load_duty_of(joints, kind), carries_nothing(joints, loads)};
    });
}

// Over that at the reference; none if its joints carry no load there.
std::optional<double> FrictionLaws::load_ratio(const std::string& row, const casefile::Segment& segment,
                                               const casefile::CalibratedFriction& friction)
{
    casefile::CalibratedFriction law;
    law.kind = friction.kind;
    auto duty = input_.friction.at(row);
    duty.lubricant.clear();
    duty.law = law;
    const auto inputs = inputs_of(row, std::move(duty));
    const auto then = load_duty(row, inputs, reference_key(friction), reference(friction));
    if (then.unloaded)
        return std::nullopt;
    return load_duty(row, inputs, {{segment.speed, segment.force}, false, 0}, loads(segment)).sum / then.sum;
}

const CalibratedAt& FrictionLaws::calibrated_at(const std::string& row, const casefile::Segment& segment)
{
    const LawAt key{row, {segment.speed, segment.force}};
    if (const auto found = calibrated_.find(key); found != calibrated_.end())
        return found->second;
    const auto& friction = input_.friction.at(row);
    const auto& given = std::get<casefile::CalibratedFriction>(friction.law);
    CalibratedAt result;
    result.law.kind = given.kind;
    result.law.load_part = given.load_part;
    result.law.viscous_part = given.viscous_part;
    result.law.exponent = given.exponent;
    result.law.reference_speed = given.reference_speed;
    result.law.scale = friction.scale;
    result.duty = tribology::speed_ratio(result.law, segment.speed);
    if (given.reference_force && segment.speed > 0) {
        result.load_ratio = load_ratio(row, segment, given);
        result.unloaded = !result.load_ratio;
        result.duty.load = result.load_ratio.value_or(result.duty.load);
    }
    return calibrated_.emplace(key, result).first->second;
}

FrictionHeat FrictionLaws::calibrated(const std::string& row, const casefile::Segment& segment)
{
    const auto& friction = input_.friction.at(row);
    const auto& at = calibrated_at(row, segment);
    FrictionHeat result;
    result.unloaded = at.unloaded;
    result.load_ratio = at.load_ratio;
    tribology::ViscosityLaw viscosity;
    if (!friction.lubricant.empty())
        viscosity = viscosity_law(input_, friction.lubricant);
    result.heat = tribology::calibrated_heat(at.law, viscosity, segment.speed, at.duty);
    result.load_part = tribology::heat_parts(at.law, at.duty).load;
    return result;
}

// Laws with one lubricant and exponent differ by their parts only.
LawTable FrictionLaws::calibrated_table(const std::string& row, const casefile::Segment& segment)
{
    const auto& at = calibrated_at(row, segment);
    const auto parts = tribology::heat_parts(at.law, at.duty);
    if (parts.viscous == 0)
        return LawTable(heat(row, segment).heat);
    const auto& lubricant = input_.friction.at(row).lubricant;
    casefile::Case inputs;
    inputs.lubricants.emplace(lubricant, input_.lubricants.at(lubricant));
    casefile::CalibratedFriction shape;
    shape.kind = at.law.kind;
    shape.exponent = at.law.exponent;
    inputs.friction[lubricant].law = shape;
    inputs.operation.emplace_back().speed = at.law.kind == FrictionKind::rolling ? segment.speed : 0;
    const auto table = kept_->shapes->get(casefile::case_bytes(std::move(inputs)), [&] {
        return LawTable(tribology::viscous_shape(at.law, viscosity_law(input_, lubricant), segment.speed));
    });
    return table->affine(parts.viscous, parts.load);
}

std::shared_ptr<const FrictionHeat> FrictionLaws::unscaled_heat(const std::string& row,
                                                                const casefile::Segment& segment)
{
    const auto& friction = input_.friction.at(row);
    const auto& now = loads(segment);
    return kept_->heats.get({inputs_of(row, friction), {{segment.speed, segment.force}, false, 0}}, [&] {
        const auto parts = physical_heat(input_, friction, rubbing_joints(row, now));
        FrictionHeat result;
        result.heat = parts.heat;
        result.load_part = parts.load_part;
        result.ring_heat = parts.ring_heat;
        return result;
    });
}

FrictionHeat FrictionLaws::physical(const std::string& row, const casefile::Segment& segment)
{
    FrictionHeat result;
    if (segment.speed == 0) {
        result.heat = tribology::constant_heat(0);
        result.load_part = 0;
        return result;
    }
    const auto unscaled = unscaled_heat(row, segment);
    const double scale = input_.friction.at(row).scale;
    result.heat = [unscaled, scale](double temperature) {
        const LawValue value = unscaled->heat(temperature);
        return LawValue{scale * value.value, scale * value.slope, value.in_range};
    };
    if (unscaled->load_part)
        result.load_part = scale * *unscaled->load_part;
    if (unscaled->ring_heat)
        result.ring_heat = [unscaled, scale](double difference) { return scale * unscaled->ring_heat(difference); };
    return result;
}

LawTable FrictionLaws::physical_table(const std::string& row, const casefile::Segment& segment)
{
    const auto& friction = input_.friction.at(row);
    const auto table = kept_->tables.get({inputs_of(row, friction), {{segment.speed, segment.force}, false, 0}},
                                         [&] { return LawTable(unscaled_heat(row, segment)->heat); });
    return table->affine(friction.scale, 0);
}

const FrictionHeat& FrictionLaws::heat(const std::string& row, const casefile::Segment& segment)
{
    const LawAt key{row, {segment.speed, segment.force}};
    auto found = heats_.find(key);
    if (found == heats_.end())
        found = heats_.emplace(key, computed_heat(row, segment)).first;
    return found->second;
}

LawTable FrictionLaws::table(const std::string& row, const casefile::Segment& segment)
{
    if (segment.speed == 0)
        return {};
    return about("friction." + row, [&] {
        return is_calibrated(input_.friction.at(row)) ? calibrated_table(row, segment) : physical_table(row, segment);
    });
}

FrictionHeat FrictionLaws::computed_heat(const std::string& row, const casefile::Segment& segment)
{
    const auto& friction = input_.friction.at(row);
    auto result = about("friction." + row,
                        [&] { return is_calibrated(friction) ? calibrated(row, segment) : physical(row, segment); });
    result.row = row;
    result.law = casefile::law_name(friction);
    for (const auto& [name, joint] : input_.joints)
        if (joint.friction == row)
            result.joints.push_back(name);
    return result;
}

void FrictionLaws::contrast_bearings(FrictionSummary& result, const LoadsResult& loads)
{
    if (!loads.crankshaft)
        return;
    const auto& rigid = loads.crankshaft->rigid.bearings;
    const std::vector<BearingCycle>* flexible = nullptr;
    if (loads.crankshaft->flexible) {
        flexible = &loads.crankshaft->flexible->bearings;
    } else {
        for (const auto& [name, joint] : input_.joints) {
            const auto row = input_.friction.find(joint.friction);
            const auto* law =
                row == input_.friction.end() ? nullptr : std::get_if<casefile::CalibratedFriction>(&row->second.law);
            if (joint.driver && law && law->reference_force && law->reference_speed == loads.speed)
                flexible = &reference(*law).crankshaft->flexible->bearings;
        }
        result.same_loads = false;
    }
    if (!flexible)
        return;
    for (std::size_t b = 0; b < rigid.size(); ++b)
        result.bearings.push_back({rigid[b].name, rigid[b].mean_rolling_load / (*flexible)[b].mean_rolling_load,
                                   std::pow(rigid[b].peak / (*flexible)[b].peak, tribology::rolling_load_exponent)});
}

FrictionSummary FrictionLaws::summary(const casefile::Segment& segment)
{
    FrictionSummary result;
    result.speed = segment.speed;
    result.force = segment.force;
    Mistakes mistakes;
    for (const auto& [name, row] : input_.friction)
        mistakes.attempt("friction." + name, [&, &name = name] { result.rows.push_back(heat(name, segment)); });
    mistakes.raise();
    if (!has_loads(input_) || !(segment.speed > 0))
        return result;
    const auto& now = loads(segment);
    contrast_bearings(result, now);
    result.balance = power_balance(input_, result, now);
    return result;
}

std::vector<FrictionSummary> FrictionLaws::summaries()
{
    std::vector<FrictionSummary> result;
    for (const auto& segment : input_.operation) {
        const auto same = [&](const FrictionSummary& other) {
            return other.speed == segment.speed && other.force == segment.force;
        };
        if (segment.speed > 0 && std::ranges::none_of(result, same))
            result.push_back(summary(segment));
    }
    return result;
}

std::vector<std::string> FrictionLaws::warnings(const std::vector<FrictionSummary>& summaries) const
{
    auto result = warnings_;
    const auto add = [&](const std::string& text) {
        if (std::ranges::find(result, text) == result.end())
            result.push_back(text);
    };
    for (const auto& summary : summaries) {
        for (const auto& row : summary.rows)
            if (row.unloaded)
                add(unloaded_text(row));
        for (const auto& warning : power_warnings(summary))
            add(warning);
    }
    return result;
}

}  // namespace deadpoint::press
