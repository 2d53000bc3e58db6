"""The lessons of the notebooks: each function makes one, with numbers that can be changed.

``LESSONS`` lists them by name, in the order in which the notebooks use them.
"""

from collections.abc import Callable

from dhlab.lessons.course.assigning import (
    common_normal,
    frame_in_the_air,
    parallel_axes,
    two_right_tables,
)
from dhlab.lessons.course.chains import chain_by_hand, planar_arm, zero_pose_is_a_choice
from dhlab.lessons.course.conventions import column_order, one_table_two_readings, whose_link
from dhlab.lessons.course.ends import (
    base_and_tool,
    degrees_or_radians,
    limits_of_what,
    offset_forgotten,
)
from dhlab.lessons.course.frames import one_point_two_frames, place_a_frame, point, right_hand
from dhlab.lessons.course.motions import joints_or_space
from dhlab.lessons.course.orientations import gimbal_lock, three_conventions
from dhlab.lessons.course.rotations import columns_are_axes, which_way_round
from dhlab.lessons.course.sequences import moving_or_fixed, order_matters, predict_a_sequence
from dhlab.lessons.course.tables import prismatic, sign_of_twist, which_axis
from dhlab.lessons.course.transforms import detour, from_a_to_b
from dhlab.lessons.course.trees import branching, sticks_or_bodies
from dhlab.lessons.lesson import Lesson

LESSONS: dict[str, Callable[[], Lesson]] = {
    make.__name__: make
    for make in (
        one_point_two_frames,
        place_a_frame,
        right_hand,
        columns_are_axes,
        which_way_round,
        order_matters,
        moving_or_fixed,
        predict_a_sequence,
        from_a_to_b,
        detour,
        three_conventions,
        gimbal_lock,
        chain_by_hand,
        zero_pose_is_a_choice,
        which_axis,
        sign_of_twist,
        prismatic,
        common_normal,
        parallel_axes,
        two_right_tables,
        frame_in_the_air,
        one_table_two_readings,
        whose_link,
        column_order,
        offset_forgotten,
        base_and_tool,
        degrees_or_radians,
        limits_of_what,
        joints_or_space,
        branching,
        sticks_or_bodies,
    )
}

__all__ = ["LESSONS", "planar_arm", "point", *LESSONS]
