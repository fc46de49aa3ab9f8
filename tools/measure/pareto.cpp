#include "measure/pareto.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tyndall::measure {

std::vector<size_t> pareto_front(std::span<const Outcome> outcomes) {
    std::vector<size_t> order;
    for (size_t i = 0; i < outcomes.size(); ++i)
        if (std::isfinite(outcomes[i].cost) && std::isfinite(outcomes[i].error)) order.push_back(i);
    std::ranges::stable_sort(order, [&](size_t a, size_t b) {
        return outcomes[a].cost < outcomes[b].cost ||
               (outcomes[a].cost == outcomes[b].cost && outcomes[a].error < outcomes[b].error);
    });
    std::vector<size_t> front;
    double least = std::numeric_limits<double>::infinity();
    for (const size_t i : order)
        if (outcomes[i].error < least) {
            least = outcomes[i].error;
            front.push_back(i);
        }
    return front;
}

}  // namespace tyndall::measure
