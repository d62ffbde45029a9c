import sys

import cv2
import numpy as np
import sensor_msgs.msg

#: Channels and element type of the encodings that have a name; others are `8UC3` and the like.
NAMED = {
    'rgb8': (3, 'uint8'), 'bgr8': (3, 'uint8'), 'rgba8': (4, 'uint8'), 'bgra8': (4, 'uint8'),
    'rgb16': (3, 'uint16'), 'bgr16': (3, 'uint16'), 'rgba16': (4, 'uint16'), 'bgra16': (4, 'uint16'),
    'mono8': (1, 'uint8'), 'mono16': (1, 'uint16'),
    'bayer_rggb8': (1, 'uint8'), 'bayer_bggr8': (1, 'uint8'), 'bayer_gbrg8': (1, 'uint8'), 'bayer_grbg8': (1, 'uint8'),
    'bayer_rggb16': (1, 'uint16'), 'bayer_bggr16': (1, 'uint16'),
    'bayer_gbrg16': (1, 'uint16'), 'bayer_grbg16': (1, 'uint16'),
    'yuv422': (2, 'uint8'), 'yuv422_yuy2': (2, 'uint8'), 'uyvy': (2, 'uint8'), 'yuyv': (2, 'uint8'),
}
DEPTHS = {
    '8U': 'uint8', '8S': 'int8', '16U': 'uint16', '16S': 'int16', '32S': 'int32', '32F': 'float32', '64F': 'float64',
}
TYPES = {dtype: depth for depth, dtype in DEPTHS.items()}

#: The order of colours of an encoding.
ORDERS = {
    'rgb8': 'RGB', 'rgb16': 'RGB', 'bgr8': 'BGR', 'bgr16': 'BGR',
    'rgba8': 'RGBA', 'rgba16': 'RGBA', 'bgra8': 'BGRA', 'bgra16': 'BGRA', 'mono8': 'GRAY', 'mono16': 'GRAY',
    'yuv422': 'YUV_UYVY', 'uyvy': 'YUV_UYVY', 'yuv422_yuy2': 'YUV_YUY2', 'yuyv': 'YUV_YUY2',
    'bayer_rggb8': 'BayerBG', 'bayer_bggr8': 'BayerRG', 'bayer_gbrg8': 'BayerGR', 'bayer_grbg8': 'BayerGB',
    'bayer_rggb16': 'BayerBG', 'bayer_bggr16': 'BayerRG', 'bayer_gbrg16': 'BayerGR', 'bayer_grbg16': 'BayerGB',
}


class CvBridgeError(TypeError):
    """An image that cannot be converted."""


def _split(encoding):
    """Channels and element type."""
    if encoding in NAMED:
        return NAMED[encoding]
    depth, mark, channels = encoding.partition('C')
    if depth not in DEPTHS or (mark and not channels.isdigit()):
        raise CvBridgeError(f'Unrecognized image encoding [{encoding}]')
    return int(channels or 1), DEPTHS[depth]


def _converted(image, source, target):
    if source == target:
        return image.copy()
    (channels, kind), (wanted_channels, wanted_kind) = _split(source), _split(target)
    order, wanted = ORDERS.get(source), ORDERS.get(target)
    if order is None or wanted is None:
        if (order is None) != (wanted is None) and channels != wanted_channels:
            color, other = (source, target) if order is not None else (target, source)
            raise CvBridgeError(
                f'[{other}] is not a color format. but [{color}] is. The conversion does not make sense')
        if channels != wanted_channels:
            raise CvBridgeError(
                f'Source image encoding has {channels} channels and the requested one has {wanted_channels}')
    elif order != wanted:
        if wanted.startswith(('Bayer', 'YUV')):
            raise CvBridgeError(f'Unsupported conversion from [{source}] to [{target}]')
        name = f'COLOR_YUV2{wanted}_{order[4:]}' if order.startswith('YUV') else f'COLOR_{order}2{wanted}'
        code = getattr(cv2, name, None)
        if code is None:
            raise CvBridgeError(f'Unsupported conversion from [{source}] to [{target}]')
        image = cv2.cvtColor(image, code)
    if kind == wanted_kind:
        return image
    if (kind, wanted_kind) == ('uint16', 'uint8') and order is not None and wanted is not None:
        return np.rint(image * (255.0 / 65535.0)).astype('uint8')
    if (kind, wanted_kind) == ('uint8', 'uint16') and order is not None and wanted is not None:
        return np.rint(image * (65535.0 / 255.0)).astype('uint16')
    if np.issubdtype(np.dtype(wanted_kind), np.integer):
        limits = np.iinfo(wanted_kind)
        return np.clip(np.rint(image), limits.min, limits.max).astype(wanted_kind)
    return image.astype(wanted_kind)


class CvBridge:
    def __init__(self):
        names = [f'{depth}C{channels}' for depth in DEPTHS for channels in range(1, 5)]
        self.cvtype_to_name = {getattr(cv2, f'CV_{name}'): name for name in names if hasattr(cv2, f'CV_{name}')}
        self.numpy_type_to_cvtype = dict(TYPES)

    def dtype_with_channels_to_cvtype2(self, dtype, n_channels):
        return f'{TYPES[np.dtype(dtype).name]}C{n_channels}'

    def cvtype2_to_dtype_with_channels(self, cvtype):
        return self.encoding_to_dtype_with_channels(self.cvtype_to_name[cvtype] if isinstance(cvtype, int) else cvtype)

    def encoding_to_cvtype2(self, encoding):
        channels, dtype = _split(encoding)
        return getattr(cv2, f'CV_{TYPES[dtype]}C{channels}')

    def encoding_to_dtype_with_channels(self, encoding):
        channels, dtype = _split(encoding)
        return dtype, channels

    def imgmsg_to_cv2(self, img_msg, desired_encoding='passthrough'):
        """The array of a message: height, width and, if there are several, channels."""
        name, channels = self.encoding_to_dtype_with_channels(img_msg.encoding)
        dtype = np.dtype(name).newbyteorder('>' if img_msg.is_bigendian else '<')
        data = np.asarray(img_msg.data, dtype='uint8') if isinstance(img_msg.data, list) else img_msg.data
        columns = int(img_msg.step / dtype.itemsize / channels)
        shape = (img_msg.height, columns) if channels == 1 else (img_msg.height, columns, channels)
        image = np.ndarray(shape=shape, dtype=dtype, buffer=data)
        image = np.ascontiguousarray(image[:img_msg.height, :img_msg.width])
        if img_msg.is_bigendian == (sys.byteorder == 'little'):
            image = image.byteswap().view(image.dtype.newbyteorder())
        if desired_encoding == 'passthrough':
            return image
        try:
            return _converted(image.astype(name, copy=False), img_msg.encoding, desired_encoding)
        except cv2.error as error:
            raise CvBridgeError(error) from error

    def cv2_to_imgmsg(self, cvim, encoding='passthrough', header=None):
        """The message of an array."""
        if not isinstance(cvim, (np.ndarray, np.generic)):
            raise TypeError('Your input type is not a numpy array')
        message = sensor_msgs.msg.Image()
        message.height, message.width = cvim.shape[:2]
        if header is not None:
            message.header = header
        kind = self.dtype_with_channels_to_cvtype2(cvim.dtype, 1 if cvim.ndim < 3 else cvim.shape[2])
        if encoding == 'passthrough':
            message.encoding = kind
        else:
            message.encoding = encoding
            channels, dtype = _split(encoding)
            if f'{TYPES[dtype]}C{channels}' != kind:
                raise CvBridgeError(f'encoding specified as {encoding}, but image has incompatible type {kind}')
        message.is_bigendian = cvim.dtype.byteorder == '>'
        message.data.frombytes(cvim.tobytes())
        message.step = len(message.data) // message.height
        return message

    def compressed_imgmsg_to_cv2(self, cmprs_img_msg, desired_encoding='passthrough'):
        """The array of a compressed message: in colour with blue first, or in gray."""
        image = cv2.imdecode(np.frombuffer(cmprs_img_msg.data, np.uint8), cv2.IMREAD_ANYCOLOR)
        if desired_encoding == 'passthrough':
            return image
        try:
            return _converted(image, 'mono8' if image.ndim < 3 else 'bgr8', desired_encoding)
        except cv2.error as error:
            raise CvBridgeError(error) from error

    def cv2_to_compressed_imgmsg(self, cvim, dst_format='jpg'):
        """A message in that form of a file."""
        if not isinstance(cvim, (np.ndarray, np.generic)):
            raise TypeError('Your input type is not a numpy array')
        message = sensor_msgs.msg.CompressedImage()
        message.format = dst_format
        message.data.frombytes(np.array(cv2.imencode('.' + dst_format, cvim)[1]).tobytes())
        return message
