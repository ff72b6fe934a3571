"""Least squares by Levenberg and Marquardt over a few parameters, where every evaluation is a run of a program.

Parameters are logarithms, so that a step is a relative change. Derivatives are finite differences.
"""

DIFFERENCE = 0.1  # step of the finite differences
LONGEST_STEP = 1.5  # of a parameter in one iteration
SMALLEST_STEP = 0.01  # below it the fit has converged
SMALLEST_GAIN = 1e-3  # nor does it go on for a thousandth of the sum of squares


def solve(matrix, right):
    """Solution of a small linear system, by elimination with pivoting."""
    rows = [list(row) + [value] for row, value in zip(matrix, right)]
    n = len(rows)
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(k + 1, n):
            factor = rows[i][k] / rows[k][k]
            rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k])]
    x = [0.0] * n
    for k in reversed(range(n)):
        x[k] = (rows[k][n] - sum(rows[k][j] * x[j] for j in range(k + 1, n))) / rows[k][k]
    return x


def sum_of_squares(differences):
    return sum(value * value for value in differences.values())


def jacobian(model, parameters, differences):
    """Columns d(differences)/d(parameter), one per parameter."""
    columns = []
    for k in range(len(parameters)):
        there = model([value + (DIFFERENCE if i == k else 0.0) for i, value in enumerate(parameters)])
        columns.append([(there[name] - differences[name]) / DIFFERENCE for name in differences])
    return columns


def damped_step(columns, differences, damping):
    """Levenberg-Marquardt step with Marquardt's scaling, each entry cut at LONGEST_STEP."""
    normal = [[sum(a * b for a, b in zip(u, v)) for v in columns] for u in columns]
    for k in range(len(columns)):
        normal[k][k] = normal[k][k] * (1.0 + damping) + 1e-9
    gradient = [-sum(a * b for a, b in zip(u, differences.values())) for u in columns]
    return [max(-LONGEST_STEP, min(LONGEST_STEP, value)) for value in solve(normal, gradient)]


def fit(model, start, iterations, bounds, tell=lambda label, parameters, differences: None):
    """The best parameters found, the differences there, and why the fit ended.

    model       from parameters to computed minus wanted, by name
    bounds      least and largest value of every parameter
    tell        called after each evaluation that counts, and after those that are rejected
    """
    parameters, differences = list(start), model(start)
    tell("start", parameters, differences)
    damping = 1e-3
    for iteration in range(1, iterations + 1):
        columns = jacobian(model, parameters, differences)
        while True:
            step = damped_step(columns, differences, damping)
            trial = [max(bounds[0], min(bounds[1], a + b)) for a, b in zip(parameters, step)]
            if max(abs(a - b) for a, b in zip(trial, parameters)) < SMALLEST_STEP:
                return parameters, differences, "converged: the next step would change no coefficient by 1 %"
            there = model(trial)
            if sum_of_squares(there) < sum_of_squares(differences):
                break
            tell("rejected", trial, there)
            damping = max(10.0 * damping, 1e-2)
        gain = 1.0 - sum_of_squares(there) / sum_of_squares(differences)
        parameters, differences, damping = trial, there, 0.1 * damping
        tell(str(iteration), parameters, differences)
        if gain < SMALLEST_GAIN:
            return parameters, differences, "converged: the sum of squares fell by less than a thousandth"
    return parameters, differences, f"note: not converged after {iterations} iterations"
