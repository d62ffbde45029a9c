def is_even(parameter):
    return '' if parameter.value % 2 == 0 else f'{parameter.name} is odd'
