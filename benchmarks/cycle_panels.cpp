// The cylinder of cycle_720.cpp by hand, as exact as ours: the cycle in panels between dead centres and the end of heat,
// narrower beside the pole that a pressure has next to its least volume; Chebyshev's points with both ends; largest and
// smallest torque by Newton's method on the series of a panel. It is told beforehand what ours has to find: that no
// panel has to be narrower, that volumes turn at 0 and 180 degrees, and in which strokes gas is at rest.
//
//     g++ -O3 -march=native -ffast-math -o cycle_panels cycle_panels.cpp && ./cycle_panels 100000
//
// Prints processor time in microseconds a design, the largest torque of the first design, and a sum over all designs
// that has to be computed.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

constexpr double PI = 3.14159265358979323846;
constexpr int SIZES[4] = {8, 12, 18, 26}, MOST_POINTS = 1024, MOST_PANELS = 40;
constexpr double SHARES[3] = {0.05, 0.2, 0.5}, WIDEST = 3.2, REACH = 2.2;
constexpr double LOOKED_AT = 0.02;  // of the range: a top between points may stand so much above these

struct Design {
    double radius, rod, area, ratio, mass, speed;
    double start, compression, expansion, raise, cut_off, ambient;
};

struct Panel {
    double start, width;
    int size, first;
};

// Points in [-1, 1], and what makes coefficients of Chebyshev's polynomials of values there.
static double place[4][26], to_series[4][26][26];

static void make_tables() {
    for (int s = 0; s < 4; ++s) {
        const int last = SIZES[s] - 1;
        for (int i = 0; i <= last; ++i) place[s][i] = -std::cos(PI * i / last);
        for (int k = 0; k <= last; ++k)
            for (int i = 0; i <= last; ++i) {
                const double ends = (i == 0 || i == last ? 0.5 : 1.0) * (k == 0 || k == last ? 0.5 : 1.0);
                to_series[s][i][k] = 2.0 / last * ends * std::cos(PI * k * (last - i) / last);
            }
    }
}

struct Cycle {
    Panel panels[MOST_PANELS];
    int n_panels = 0, n_points = 0;
    double angle[MOST_POINTS], torque[MOST_POINTS];

    // Panels from one event to the next; `away` is how far the pole beside firing is from the real axis.
    void cut(double start, double end, double away) {
        while (end - start > 1e-11) {
            double width = end - start, widest = widest_at(start, width, away);
            while (width > widest * (1 + 1e-11)) {
                width = std::max(widest, width / 2);
                widest = widest_at(start, width, away);
            }
            int size = 0;
            while (size < 3 && width > SHARES[size] * widest) ++size;
            panels[n_panels++] = {start, width, size, n_points};
            const double half = width / 2, middle = start + half;
            for (int i = 0; i < SIZES[size]; ++i) angle[n_points + i] = middle + half * place[size][i];
            n_points += SIZES[size];
            start += width;
        }
    }

    static double widest_at(double start, double width, double away) {
        const double beside = std::max(std::min(start, 4 * PI - start - width), 0.0);
        return std::min(WIDEST, REACH * std::sqrt(beside * beside + away * away));
    }

    // Largest torque, or for sign -1 the largest of -torque: about every point that may be next to it.
    double highest(double sign) const {
        double most = -1e300, least = 1e300;
        for (int i = 0; i < n_points; ++i) {
            most = std::max(most, sign * torque[i]);
            least = std::min(least, sign * torque[i]);
        }
        const double enough = most - LOOKED_AT * (most - least);
        double best = most;
        for (int p = 0; p < n_panels; ++p) {
            const Panel& own = panels[p];
            const int size = SIZES[own.size];
            const double* values = torque + own.first;
            double series[26];
            bool has_series = false;
            for (int i = 0; i < size; ++i) {
                const double height = sign * values[i];
                if (height < enough) continue;
                if ((i > 0 && sign * values[i - 1] > height) || (i < size - 1 && sign * values[i + 1] > height)) continue;
                if (!has_series) {
                    std::fill(series, series + size, 0.0);
                    for (int j = 0; j < size; ++j)
                        for (int k = 0; k < size; ++k) series[k] += sign * to_series[own.size][j][k] * values[j];
                    has_series = true;
                }
                best = std::max(best, top(series, size, place[own.size], i));
            }
        }
        return best;
    }

    static double top(const double* series, int size, const double* points, int i) {
        const double low = points[std::max(i - 1, 0)], high = points[std::min(i + 1, size - 1)];
        double x = points[i], at = 0;
        for (int step = 0; step < 12; ++step) {
            double one = x, other = 1, slope_one = 1, slope_other = 0, bend_one = 0, bend_other = 0;
            double slope = series[1], bend = 0;
            at = series[0] + series[1] * x;
            for (int k = 2; k < size; ++k) {
                const double next = 2 * x * one - other;
                const double slope_next = 2 * one + 2 * x * slope_one - slope_other;
                const double bend_next = 4 * slope_one + 2 * x * bend_one - bend_other;
                other = one, one = next;
                slope_other = slope_one, slope_one = slope_next;
                bend_other = bend_one, bend_one = bend_next;
                at += series[k] * one;
                slope += series[k] * slope_one;
                bend += series[k] * bend_one;
            }
            const double uphill = slope > 0 ? (high - x) / 2 : (low - x) / 2;
            const double move = bend < 0 ? std::clamp(-slope / bend, low - x, high - x) : uphill;
            x += move;
            // what is left of the top then is half the bend times the square of the move
            if (std::abs(move) < 1e-8) break;
        }
        return at;
    }
};

static void solve(const Design& d, Cycle& cycle) {
    const double swept = 2 * d.radius * d.area, least = swept / (d.ratio - 1), most = least + swept;
    const double peak = d.raise * d.start * std::pow(d.ratio, d.compression), end = d.cut_off * least;
    // the triangle of crank and rod when heat ends
    const double reach_there = d.radius + d.rod - (end - least) / d.area;
    const double heated = std::acos((reach_there * reach_there + d.radius * d.radius - d.rod * d.rod)
                                    / (2 * d.radius * reach_there));
    const double away = std::sqrt(2 * least / (d.area * d.radius * (1 + d.radius / d.rod)));
    cycle.n_panels = cycle.n_points = 0;
    cycle.cut(0, heated, away);
    const int n_heated = cycle.n_points;
    cycle.cut(heated, PI, away);
    const int n_expanded = cycle.n_points;
    cycle.cut(PI, 2 * PI, away);
    cycle.cut(2 * PI, 3 * PI, away);
    const int n_changed = cycle.n_points;
    cycle.cut(3 * PI, 4 * PI, away);
    double volume[MOST_POINTS], slope[MOST_POINTS], inertia[MOST_POINTS], pressure[MOST_POINTS];
    double cosine[MOST_POINTS], sine[MOST_POINTS];
    // in loops of their own, or GCC makes a call of sincos for each point of them
    for (int i = 0; i < cycle.n_points; ++i) cosine[i] = std::cos(cycle.angle[i]);
    for (int i = 0; i < cycle.n_points; ++i) sine[i] = std::sin(cycle.angle[i]);
    for (int i = 0; i < cycle.n_points; ++i) {
        const double along = d.radius * cosine[i], rise = d.radius * sine[i];
        const double reach = std::sqrt((d.rod - rise) * (d.rod + rise)), turn = -along / reach;
        volume[i] = least + d.area * (d.radius + d.rod - along - reach);
        slope[i] = -rise + rise * turn;
        inertia[i] = d.mass * d.speed * d.speed * (-along + along * turn + rise * rise * (1 - turn * turn) / reach);
    }
    for (int i = 0; i < n_heated; ++i) pressure[i] = peak;
    for (int i = n_heated; i < n_expanded; ++i) pressure[i] = peak * std::exp(d.expansion * std::log(end / volume[i]));
    for (int i = n_expanded; i < n_changed; ++i) pressure[i] = d.start;
    for (int i = n_changed; i < cycle.n_points; ++i)
        pressure[i] = d.start * std::exp(d.compression * std::log(most / volume[i]));
    for (int i = 0; i < cycle.n_points; ++i)
        cycle.torque[i] = -((pressure[i] - d.ambient) * d.area + inertia[i]) * slope[i];
}

int main(int argc, char** argv) {
    const int designs = argc > 1 ? std::atoi(argv[1]) : 100000;
    make_tables();
    static Cycle cycle;
    double total = 0, first = 0;
    const clock_t begin = clock();
    for (int k = 0; k < designs; ++k) {
        const Design d{0.045, 0.15 + 1e-7 * k, PI / 4 * 0.08 * 0.08, 10, 0.7, 350, 1e5, 1.36, 1.25, 1.5, 1.3, 101325};
        solve(d, cycle);
        const double largest = cycle.highest(1), smallest = -cycle.highest(-1);
        if (k == 0) first = largest;
        total += largest + smallest;
    }
    const double seconds = double(clock() - begin) / CLOCKS_PER_SEC;
    std::printf("%.4f %.15g %.9g\n", 1e6 * seconds / designs, first, total / designs);
}
