// A single cylinder by hand, as one would write it for this alone: 720 equal crank angles of a four-stroke cycle, the
// ideal dual cycle, a rod as two masses; largest and smallest torque off the grid, unrefined.
//
//     g++ -O3 -march=native -ffast-math -o cycle_720 cycle_720.cpp && ./cycle_720 100000
//
// Prints processor time in microseconds a design, the largest torque of the first design, and a sum over all designs
// that has to be computed.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

constexpr int N = 720;
constexpr double PI = 3.14159265358979323846;

struct Design {
    double radius, rod, area, ratio, mass, speed;
    double start, compression, expansion, raise, cut_off, ambient;
};

static double cosine[N], sine[N];

int main(int argc, char** argv) {
    const int designs = argc > 1 ? std::atoi(argv[1]) : 100000;
    for (int i = 0; i < N; ++i) {
        cosine[i] = std::cos(4 * PI * i / N);
        sine[i] = std::sin(4 * PI * i / N);
    }
    double total = 0, first = 0;
    const clock_t begin = clock();
    for (int k = 0; k < designs; ++k) {
        const Design d{0.045, 0.15 + 1e-7 * k, PI / 4 * 0.08 * 0.08, 10, 0.7, 350, 1e5, 1.36, 1.25, 1.5, 1.3, 101325};
        const double swept = 2 * d.radius * d.area, least = swept / (d.ratio - 1), most = least + swept;
        const double peak = d.raise * d.start * std::pow(d.ratio, d.compression);
        const double end = d.cut_off * least, c1 = d.start * std::pow(most, d.compression);
        const double c2 = peak * std::pow(end, d.expansion);
        double force[N], slope[N];
        for (int i = 0; i < N; ++i) {
            const double rise = d.radius * sine[i];
            const double reach = std::sqrt((d.rod - rise) * (d.rod + rise)), turn = -d.radius * cosine[i] / reach;
            const double volume = least + d.area * (d.radius + d.rod - d.radius * cosine[i] - reach);
            slope[i] = -rise + rise * turn;
            const double bend = -d.radius * cosine[i] + d.radius * cosine[i] * turn
                                + rise * rise * (1 - turn * turn) / reach;
            double pressure = d.start;
            if (i < N / 4) pressure = volume < end ? peak : c2 * std::exp(-d.expansion * std::log(volume));
            if (i >= 3 * N / 4) pressure = c1 * std::exp(-d.compression * std::log(volume));
            force[i] = (pressure - d.ambient) * d.area + d.mass * d.speed * d.speed * bend;
        }
        double largest = -1e300, smallest = 1e300;
        for (int i = 0; i < N; ++i) {
            const double torque = -force[i] * slope[i];
            largest = std::max(largest, torque);
            smallest = std::min(smallest, torque);
        }
        if (k == 0) first = largest;
        total += largest + smallest;
    }
    const double seconds = double(clock() - begin) / CLOCKS_PER_SEC;
    std::printf("%.4f %.15g %.9g\n", 1e6 * seconds / designs, first, total / designs);
}
