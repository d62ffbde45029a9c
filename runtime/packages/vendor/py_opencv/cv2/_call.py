"""Calls of OpenCV.js with the parameters and results of OpenCV's own Python module.

Arrays of numpy are copied into OpenCV's memory and back; see runtime/site/python/opencv.ts for how a call is written.
"""
import ast
import json
import re
from importlib import resources

import numpy
import ros2wasm_host
from cv2 import _table

#: By OpenCV's number of an element type.
DTYPES = [numpy.dtype(name) for name in ('uint8', 'int8', 'uint16', 'int16', 'int32', 'float32', 'float64')]
DEPTHS = {dtype: depth for depth, dtype in enumerate(DTYPES)}
#: As OpenCV takes them.
CASTS = {numpy.dtype(name): numpy.dtype('int32') for name in ('int64', 'uint64', 'uint32')}
MOST_CHANNELS = 512
CHANNEL_BITS = 3
#: The border of dilate() and erode(), which stands for a value that is never taken.
MORPHOLOGY = (float(numpy.finfo('float64').max),) * 4


class error(Exception):
    """A call that OpenCV refuses."""

    def __init__(self, message, code=0, func='', file='', line=0):
        super().__init__(message)
        self.msg = message
        self.err = message
        self.code = code
        self.func = func
        self.file = file
        self.line = line


class KeyPoint:
    def __init__(self, x=0.0, y=0.0, size=0.0, angle=-1.0, response=0.0, octave=0, class_id=-1):
        self.pt = (float(x), float(y))
        self.size = size
        self.angle = angle
        self.response = response
        self.octave = octave
        self.class_id = class_id

    def __repr__(self):
        return f'< cv2.KeyPoint {id(self):#x}>'


class DMatch:
    def __init__(self, _queryIdx=-1, _trainIdx=-1, _imgIdx=-1, _distance=float(numpy.finfo('float32').max)):
        if isinstance(_imgIdx, float):
            _imgIdx, _distance = 0, _imgIdx
        self.queryIdx = _queryIdx
        self.trainIdx = _trainIdx
        self.imgIdx = _imgIdx
        self.distance = _distance

    def __repr__(self):
        return f'< cv2.DMatch {id(self):#x}>'

    def __lt__(self, other):
        return self.distance < other.distance


for _one in (error, KeyPoint, DMatch):
    _one.__module__ = 'cv2'


def _bad(function, name, why):
    return error(
        f"OpenCV(4.13.0) :-1: error: (-5:Bad argument) in function '{function}'\n"
        f'> Overload resolution failed:\n>  - {why.format(name=name)}\n', -5, function)


def _array(value, function, name):
    """As an array that OpenCV takes, whole and in one piece."""
    if isinstance(value, (bool, int, float, numpy.number)) and not isinstance(value, numpy.ndarray):
        return numpy.array([float(value), 0, 0, 0])
    if isinstance(value, (tuple, list)):
        is_numeric = all(isinstance(one, (int, float, numpy.number)) for one in value)
        value = numpy.array(value, dtype='float64') if is_numeric else None
    if not isinstance(value, numpy.ndarray):
        raise _bad(function, name, '{name} is not a numpy array, neither a scalar')
    if value.dtype not in DEPTHS:
        if value.dtype not in CASTS:
            raise _bad(function, name, '{name} data type = ' + f'{value.dtype.num} is not supported')
        value = value.astype(CASTS[value.dtype])
    if value.ndim > 3 or (value.ndim == 3 and value.shape[2] > MOST_CHANNELS):
        raise _bad(function, name, '{name} has more dimensions than this cv2 takes')
    return numpy.ascontiguousarray(value)


def _head(array):
    """Rows, columns and type of an array as a Mat."""
    rows = array.shape[0] if array.ndim > 0 else 1
    columns = array.shape[1] if array.ndim > 1 else 1
    channels = array.shape[2] if array.ndim > 2 else 1
    return [rows, columns, DEPTHS[array.dtype] | (channels - 1) << CHANNEL_BITS]


def _address(array):
    return array.__array_interface__['data'][0]


INTEGERS = (int, numpy.integer)
NUMBERS = (int, float, numpy.integer, numpy.floating)


class Unparsed(Exception):
    """A value of a wrong type. The text is that of OpenCV; `{name}` is the parameter."""


def _integer(value):
    if isinstance(value, bool) or not isinstance(value, INTEGERS):
        raise Unparsed("Argument '{name}' is required to be an integer")
    return int(value)


def _number(value):
    if not isinstance(value, NUMBERS):
        raise Unparsed("Argument '{name}' can not be treated as a double")
    return float(value)


def _items(value, count, types):
    try:
        items = list(value)
    except TypeError:
        raise Unparsed("Can't parse '{name}'. Input argument doesn't provide sequence protocol") from None
    if len(items) != count:
        raise Unparsed("Can't parse '{name}'. Expected sequence length " + f'{count}, got {len(items)}')
    for index, one in enumerate(items):
        if not isinstance(one, types):
            raise Unparsed("Can't parse '{name}'. Sequence item with index " + f'{index} has a wrong type')
    return [one.item() if isinstance(one, numpy.generic) else one for one in items]


def _pair(value):
    return _items(value, 2, NUMBERS)


def _size(value):
    return dict(zip(('width', 'height'), (0, 0) if value is None else _items(value, 2, INTEGERS)))


def _rotated(value):
    try:
        center, size, angle = value
    except (TypeError, ValueError):
        raise Unparsed("Can't parse '{name}'. Expected ((x, y), (width, height), angle)") from None
    (x, y), (width, height) = _pair(center), _pair(size)
    return {'center': {'x': x, 'y': y}, 'size': {'width': width, 'height': height}, 'angle': float(angle)}


def _scalar(value):
    if isinstance(value, NUMBERS):
        value = (value,)
    numbers = list(value)
    if len(numbers) > 4:
        raise Unparsed("Scalar value for argument '{name}' is longer than 4")
    if not all(isinstance(one, NUMBERS) for one in numbers):
        raise Unparsed("Scalar value for argument '{name}' is not numeric")
    return [float(one) for one in numbers] + [0.0] * (4 - len(numbers))


def _keypoint(one):
    return {'pt': {'x': one.pt[0], 'y': one.pt[1]}, 'size': one.size, 'angle': one.angle, 'response': one.response,
            'octave': one.octave, 'class_id': one.class_id}


def _match(one):
    return {'queryIdx': one.queryIdx, 'trainIdx': one.trainIdx, 'imgIdx': one.imgIdx, 'distance': one.distance}


#: How a value of a type is written, if it is not an array.
WRITERS = {
    'int': _integer,
    'float': _number,
    'bool': bool,
    'str': str,
    'size': lambda value: {'j': _size(value)},
    'point': lambda value: {'j': dict(zip('xy', _items(value, 2, INTEGERS)))},
    'point2f': lambda value: {'j': dict(zip('xy', _pair(value)))},
    'scalar': lambda value: {'j': _scalar(value)},
    'rect': lambda value: {'j': dict(zip(('x', 'y', 'width', 'height'), _items(value, 4, INTEGERS)))},
    'rrect': lambda value: {'j': _rotated(value)},
    'term': lambda value: {'j': dict(zip(('type', 'maxCount', 'epsilon'), value))},
    'list': lambda value: {'j': [float(one) if isinstance(one, float) else int(one) for one in value]},
    'plain': lambda value: {'j': value},
    'object': lambda value: {'o': value._id},
    'keypoints': lambda value: {'v': ['KeyPointVector', [_keypoint(one) for one in value]]},
    'matches': lambda value: {'v': ['DMatchVector', [_match(one) for one in value]]},
}

#: Classes of results that are not arrays.
EMPTY = {
    'mats': 'MatVector', 'keypoints': 'KeyPointVector', 'matches': 'DMatchVector',
    'lists_of_matches': 'DMatchVectorVector', 'points': 'PointVector'}


def _fetched(handle, heads):
    """The arrays that a result stands for; None for an empty one."""
    shapes = []
    for rows, columns, kind in heads:
        channels = (kind >> CHANNEL_BITS) + 1
        shapes.append(((rows, columns) if channels == 1 else (rows, columns, channels), DTYPES[kind & 7]))
    arrays = [numpy.empty(shape, dtype) for shape, dtype in shapes]
    if len(arrays) == 1:
        ros2wasm_host.opencv.fetch(handle, _address(arrays[0]))
    else:
        whole = numpy.empty(sum(one.nbytes for one in arrays), 'uint8')
        ros2wasm_host.opencv.fetch(handle, _address(whole))
        at = 0
        for one in arrays:
            one.reshape(-1).view('uint8')[:] = whole[at:at + one.nbytes]
            at += one.nbytes
    return [one if one.size else None for one in arrays]


def _keypoint_of(given):
    return KeyPoint(
        given['pt']['x'], given['pt']['y'], given['size'], given['angle'], given['response'], given['octave'],
        given['class_id'])


def _match_of(given):
    return DMatch(given['queryIdx'], given['trainIdx'], given['imgIdx'], given['distance'])


def _rotated_of(given):
    center, size = given['center'], given['size']
    return (center['x'], center['y']), (size['width'], size['height']), given['angle']


def _rect_of(given):
    return given['x'], given['y'], given['width'], given['height']


def _tracked_of(given):
    first, window = given
    return (_rotated_of(first) if isinstance(first, dict) else first), _rect_of(window)


#: How a result of a type is read.
READERS = {
    'array': lambda given: _fetched(given['m'][0], [given['m'][1:]])[0],
    'mats': lambda given: tuple(_fetched(*given['M'])),
    'keypoints': lambda given: tuple(_keypoint_of(one) for one in given),
    'matches': lambda given: tuple(_match_of(one) for one in given),
    'lists_of_matches': lambda given: tuple(tuple(_match_of(one) for one in row) for row in given),
    'points': lambda given: [(one['x'], one['y']) for one in given],
    'rect': _rect_of,
    'rrect': _rotated_of,
    'scalar': tuple,
    'circle': lambda given: ((given['center']['x'], given['center']['y']), given['radius']),
    'minmax': lambda given: (
        given['minVal'], given['maxVal'], (given['minLoc']['x'], given['minLoc']['y']),
        (given['maxLoc']['x'], given['maxLoc']['y'])),
    'tracked': _tracked_of,
}


class Parameter:
    def __init__(self, text):
        match = re.fullmatch(r'([>&]?)(\w+)(?::(\w+))?(?:=(.*))?', text)
        self.mark, self.name, kind, default = match.groups()
        self.kind = kind or 'array'
        self.is_result = self.mark != ''
        self.is_required = default is None and self.mark != '>'
        self.default = None if default is None else MORPHOLOGY if default == 'MORPHOLOGY' else ast.literal_eval(default)

    def written(self, value, function, keep):
        """The argument of a call for this value. `keep` gets what must live until the call is over."""
        if self.mark == '>' and (self.kind != 'array' or value is None):
            return {'j': {}} if self.kind == 'rect' else {'n': EMPTY.get(self.kind, 'Mat')}
        if self.kind == 'array':
            if value is None:
                return {'n': 'Mat'}
            array = _array(value, function, self.name)
            keep.append(array)
            return {'m': [_address(array), *_head(array)]}
        if self.kind == 'mats':
            arrays = [_array(one, function, self.name) for one in value]
            keep.extend(arrays)
            return {'M': [[_address(one), *_head(one)] for one in arrays]}
        writer = WRITERS.get(self.kind)
        try:
            return {'c': [self.kind, _integer(value)]} if writer is None else writer(value)
        except Unparsed as fault:
            raise _bad(function, self.name, str(fault)) from None


def _parameters(text):
    parts = re.findall(r'[>&]?\w+(?::\w+)?(?:=(?:\([^)]*\)|[^,]*))?', text)
    return [Parameter(one.strip()) for one in parts]


class Function:
    """A function that takes its arguments in the order of OpenCV's Python module.

    Those without a default come first, then the others and the results.
    """

    def __init__(self, name, text):
        head, _, returned = text.partition('->')
        self.name = name
        self.__name__ = name
        self.parameters = _parameters(head)
        self.returned = returned.strip()
        first = [one for one in self.parameters if one.is_required]
        self.order = first + [one for one in self.parameters if not one.is_required]
        self.required = len(first)
        self.results = [index for index, one in enumerate(self.parameters) if one.is_result]
        self.__doc__ = self.signature()

    def signature(self):
        needed = ', '.join(one.name for one in self.order[:self.required])
        more = ''.join(f'[, {one.name}' for one in self.order[self.required:])
        results = ['retval'] * bool(self.returned) + [one.name for one in self.parameters if one.is_result]
        return f'{self.name}({needed}{more}{"]" * (len(self.order) - self.required)}) -> {", ".join(results) or None}'

    def __repr__(self):
        return f'<built-in function {self.name}>'

    def given(self, values, named):
        """The values by parameter name."""
        if len(values) > len(self.order):
            raise _bad(self.name, '', f'{self.name}() takes at most {len(self.order)} arguments ({len(values)} given)')
        result = {one.name: value for one, value in zip(self.order, values)}
        known = {one.name for one in self.order}
        for name, value in named.items():
            if name not in known:
                raise _bad(self.name, name, f"'{{name}}' is an invalid keyword argument for {self.name}()")
            if name in result:
                raise _bad(self.name, name, f"argument for {self.name}() given by name ('{{name}}') and position")
            result[name] = value
        for position, one in enumerate(self.order[:self.required]):
            if one.name not in result:
                raise _bad(
                    self.name, one.name, f"{self.name}() missing required argument '{{name}}' (pos {position + 1})")
        return result

    def __call__(self, *values, **named):
        return self.invoke(self.name, None, values, named)

    def invoke(self, called, on, values, named):
        given = self.given(values, named)
        keep = []
        arguments = [one.written(given.get(one.name, one.default), self.name, keep) for one in self.parameters]
        call = {'f': called, 'a': arguments, 'out': self.results}
        if on is not None:
            call['on'] = on
        answer = json.loads(ros2wasm_host.opencv.call(json.dumps(call)))
        if 'e' in answer:
            code, message = answer['e']
            raise error(message, code, self.name)
        results = []
        if self.returned:
            reader = READERS.get(self.returned)
            results.append(answer['r'] if reader is None else reader(answer['r']))
        for index, one in zip(self.results, answer['o']):
            parameter = self.parameters[index]
            results.append(self.stored(given.get(parameter.name), READERS[parameter.kind](one), parameter))
        return None if not results else results[0] if len(results) == 1 else tuple(results)

    @staticmethod
    def stored(target, result, parameter):
        """A result goes into the array that was given for it, if it fits there: all who have that array see it."""
        if parameter.kind == 'array' and isinstance(target, numpy.ndarray) and result is not None:
            fits = target.shape == result.shape or parameter.mark == '&'
            if target.dtype == result.dtype and target.size == result.size and fits:
                target[...] = result.reshape(target.shape)
                return target
        return result


class Method:
    def __init__(self, function, on):
        self.function = function
        self.on = on
        self.__doc__ = function.__doc__

    def __call__(self, *values, **named):
        return self.function.invoke('.' + self.function.name, self.on._id, values, named)


class Object:
    """An object of OpenCV. Its attributes are those of the C++ class."""

    def __init__(self, name, handle, attributes=()):
        object.__setattr__(self, '_class', name)
        object.__setattr__(self, '_id', handle)
        object.__setattr__(self, '_attributes', attributes)

    def __getattr__(self, name):
        for owner in (self._class, _table.INHERITED.get(self._class)):
            function = METHODS.get(f'{owner}.{name}')
            if function is not None:
                return Method(function, self)
        if name.startswith('__') or name not in self._attributes:
            raise AttributeError(f"'cv2.{self._class}' object has no attribute '{name}'")
        return _plain('get ' + name, self._id)

    def __setattr__(self, name, value):
        if name not in self._attributes:
            raise AttributeError(f"'cv2.{self._class}' object has no attribute '{name}'")
        _plain('set ' + name, self._id, value)

    def __dir__(self):
        owners = (self._class, _table.INHERITED.get(self._class))
        own = [name.partition('.')[2] for name in METHODS if name.partition('.')[0] in owners]
        return sorted({*own, *self._attributes} - {'new'})

    def __del__(self):
        ros2wasm_host.opencv.release(self._id)


def _plain(called, on, *arguments):
    call = {'f': called, 'a': arguments, 'out': []}
    if on is not None:
        call['on'] = on
    answer = json.loads(ros2wasm_host.opencv.call(json.dumps(call)))
    if 'e' in answer:
        raise error(answer['e'][1], answer['e'][0])
    return answer.get('r')


def make(name, *values, **named):
    """A new object of a class of METHODS, or of one without parameters."""
    function = METHODS.get(name + '.new')
    arguments, keep = [], []
    if function is not None:
        given = function.given(values, named)
        arguments = [one.written(given.get(one.name, one.default), name, keep) for one in function.parameters]
    return wrap(name, _plain('new ' + name, None, *arguments))


def wrap(name, result):
    return Object(name, result['O'], frozenset(result.get('p', ())))


def ask_object(owner, method):
    """The object that a method without parameters returns."""
    return _plain('.' + method, owner._id)


def ask(called, *arguments):
    """The result of a function of OpenCV.js."""
    return _plain(called, None, *arguments)


def _read(text):
    rows = (line.partition(':') for line in re.sub('\n +', ' ', text.strip()).splitlines())
    return {name.strip(): Function(name.strip().rpartition('.')[2], rest) for name, _, rest in rows}


FUNCTIONS = _read(_table.FUNCTIONS)
METHODS = _read(_table.METHODS)

with resources.as_file(resources.files('cv2') / 'opencv.wasm') as _path:
    ros2wasm_host.opencv.open(_path.read_bytes())

NAMES = json.loads(ros2wasm_host.opencv.names())
#: Each under its name in C++, and in capitals: TermCriteria_EPS is TERM_CRITERIA_EPS, too.
CONSTANTS = {spelt: value for name, value in NAMES['constants'].items()
             for spelt in (name, re.sub('([a-z])([A-Z])', r'\1_\2', name).upper())}
