# The public face: what `import rlrobot_edu as rl` offers. Editors and mypy read it, and so does the lazy import.
from .course.bias_explorer.explorer import BiasExplorer as BiasExplorer
from .course.driving.pad import teleoperate as teleoperate
from .course.sliders import ParameterSliders as ParameterSliders
from .course.stepper.stepper import Stepper as Stepper
from .environments import make_env as make_env
from .experiments.compare import compare as compare
from .experiments.comparison import Comparison as Comparison
from .experiments.repeat import repeat as repeat
from .learning.agent import Agent as Agent
from .learning.history import History as History
from .learning.loop import Step as Step
from .learning.loop import learn as learn
from .learning.loop import steps as steps
from .models.planning import best_average_reward as best_average_reward
from .models.planning import value_iteration as value_iteration
from .models.recording import Recording as Recording
from .models.recording import read_recording as read_recording
from .models.recording import record as record
from .models.sample_model import SampleModel as SampleModel
from .models.teaching import learn_from as learn_from
from .robots.realism import Realism as Realism
from .show.curves import plot_learning as plot_learning
from .show.film import film as film
from .show.top_down import plot_scene as plot_scene
from .show.view3d.views import LiveView as LiveView
from .show.view3d.views import show_scene as show_scene
from .task.task import Task as Task
from .task.task_file import available_tasks as available_tasks
from .task.task_file import load_task as load_task
from .task.variables import InputVariable as InputVariable
from .task.variables import OutputVariable as OutputVariable
from .transferring.transfer import transfer as transfer
from .workshop.check_task import check_task as check_task
from .workshop.new_task import new_task as new_task

__version__: str
