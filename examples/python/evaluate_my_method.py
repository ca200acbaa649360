# %% [markdown]
# Where does my method fail, and what did it do there? The cells run in Jupyter (jupytext), VS Code and Spyder, and
# together as a program: python3 evaluate_my_method.py

# %%
import math

import numpy as np
import slalom

# %% A method: turns towards the goal, and slows down for what is ahead.
class MyMethod:
    options = {"gain": (2.0, "1/s", "angular velocity per radian")}

    def __init__(self, robot, options):
        self.robot, self.gain = robot, options.gain

    def reset(self, task):
        pass

    def step(self, observation):
        bearing = math.atan2(observation.goal_y, observation.goal_x)
        ahead = observation.ranges[len(observation.ranges) // 2]  # m
        v = np.clip(ahead - 0.5, 0, self.robot.max_v) if abs(bearing) < 0.5 else 0
        return v, np.clip(self.gain * bearing, -self.robot.max_w, self.robot.max_w)


# %% Scenarios; a notebook draws the last value of a cell.
scenarios = slalom.generate("random", 20, seed=1, max_obstacles=25)
scenarios[0]

# %% The method and MRPT's ND in all of them.
methods = {"mine": MyMethod, "nd": slalom.mrpt_holonomic("CHolonomicND")}
results = slalom.evaluate(methods, scenarios, trajectories=True)
print(results.table("confinement:2", ["success"]))

# %% Columns: as a data frame, or with NumPy.
try:
    import pandas

    print(pandas.DataFrame(results).groupby("method")[["success", "optimality", "safety"]].mean())
except ImportError:
    for name in methods:
        print(name, results["success"][np.array(results["method"]) == name].mean())

# %% The first scenario in which mine fails: its drawing, and the trajectory as an array.
row = next(i for i, name in enumerate(results["method"]) if name == "mine" and not results["success"][i])
scenario = next(one for one in scenarios if one.hash == results["scenario_hash"][row])
with open(f"{scenario.name}.svg", "w") as drawing:
    drawing.write(scenario._repr_svg_())
t, x, y = (results.trajectories[row][:, slalom.TRAJECTORY_COLUMNS.index(name)] for name in ("t", "x", "y"))
to_goal = np.hypot(x - scenario.goal[0], y - scenario.goal[1])
print(f"{scenario.name}: {results['outcome'][row]} after {t[-1]:.1f} s, {to_goal[-1]:.2f} m from the goal")
