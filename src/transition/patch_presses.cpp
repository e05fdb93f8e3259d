#include "integral.hpp"
#include "ruled_patch.hpp"

#include <cstddef>
#include <vector>

namespace planish::transition_detail {

template <typename Rate>
RuledPatch::Divided RuledPatch::divided(const Rate& rate, double from, double to,
                                        const std::vector<double>& shares) const {
  std::vector<PartIntegral> parts;
  const std::vector<double> breaks = breaks_between(from, to);
  for (std::size_t piece = 1; piece < breaks.size(); ++piece)
    add_parts(parts, rate, breaks[piece - 1], breaks[piece]);
  std::vector<double> behind{0.0};
  for (const PartIntegral& part : parts)
    behind.push_back(behind.back() + part.whole());
  Divided divided{behind.back(), {}};
  std::size_t part = 0;
  for (const double share : shares) {
    const double wanted = share * divided.whole;
    while (behind[part + 1] < wanted && part + 1 < parts.size())
      ++part;
    divided.rulings.push_back(parts[part].place_of(wanted - behind[part]));
  }
  return divided;
}

std::vector<RuledPatch::Press> RuledPatch::evenly_turned(double from, double to, int count) const {
  std::vector<double> middles;
  for (int i = 0; i < count; ++i)
    middles.push_back((i + 0.5) / count);
  const auto [whole, rulings] = divided([&](double at) { return local(at).turn_rate; }, from, to,
                                        middles);
  return mapped(rulings, [&](double at) { return Press{at, whole / count}; });
}

std::vector<RuledPatch::Press> RuledPatch::evenly_along(int side, double from, double to,
                                                        int count) const {
  const auto s = static_cast<std::size_t>(side);
  const auto speed = [&](double at) {
    const Pairing pair = pairing(at);
    return point(side, pair.t[s]).derivative.norm() * pair.rate[s];
  };
  std::vector<double> shares;  // limits and middles in turn
  for (int i = 0; i <= 2 * count; ++i)
    shares.push_back(0.5 * i / count);
  const std::vector<double> rulings = divided(speed, from, to, shares).rulings;
  std::vector<Press> presses;
  for (std::size_t i = 1; i < rulings.size(); i += 2)
    presses.push_back({rulings[i], turn(rulings[i - 1], rulings[i + 1])});
  return presses;
}

}  // namespace planish::transition_detail
