#include "render/reference/edge.h"

#include "math/predicates.h"

namespace enfilade {

int side_of_edge(const Edge& line, const Edge& e) {
    const int a = corner(line.a, line.b, e.a), b = corner(line.a, line.b, e.b);
    if (a * b < 0) return 0;
    return (a + b > 0) - (a + b < 0);
}

bool are_on_one_line(const Edge& e, const Edge& f) { return corner(e.a, e.b, f.a) == 0 && corner(e.a, e.b, f.b) == 0; }

bool is_in_front(const Edge& e, const Edge& f) {
    const int side = side_of_edge(e, f);
    return side != 0 ? side < 0 : side_of_edge(f, e) > 0;
}

}  // namespace enfilade
