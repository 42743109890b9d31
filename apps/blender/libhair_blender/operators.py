"""What all operators share."""

import functools

from libhair import Error


def reported(execute):
    """An operator's execute whose Error is said in Blender's way."""

    @functools.wraps(execute)
    def wrapper(self, context):
        try:
            return execute(self, context)
        except (Error, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}

    return wrapper
