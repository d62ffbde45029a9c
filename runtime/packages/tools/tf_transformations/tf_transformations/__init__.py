"""
Rotations and other transformations as Euler angles, quaternions (x, y, z, w) and homogeneous matrices.

Axes of Euler angles: `s` for those that stay or `r` for those that turn too, then three of x, y and z.
"""
from tf_transformations.arcball import (
    Arcball, arcball_constrain_to_axis, arcball_map_to_sphere, arcball_nearest_axis,
)
from tf_transformations.composition import (
    compose_matrix, concatenate_matrices, decompose_matrix, inverse_matrix, is_same_transform,
    orthogonalization_matrix, superimposition_matrix,
)
from tf_transformations.euler import (
    euler_from_matrix, euler_from_quaternion, euler_matrix, quaternion_from_euler,
)
from tf_transformations.matrices import (
    clip_matrix, identity_matrix, projection_from_matrix, projection_matrix, reflection_from_matrix,
    reflection_matrix, rotation_from_matrix, rotation_matrix, scale_from_matrix, scale_matrix, shear_from_matrix,
    shear_matrix, translation_from_matrix, translation_matrix,
)
from tf_transformations.quaternions import (
    quaternion_about_axis, quaternion_conjugate, quaternion_from_matrix, quaternion_inverse, quaternion_matrix,
    quaternion_multiply, quaternion_slerp, random_quaternion, random_rotation_matrix,
)
from tf_transformations.vectors import (
    ROTATION_IDENTITY, SHEAR_IDENTITY, TRANSLATION_IDENTITY, ZOOM_IDENTITY, random_vector, unit_vector, vector_norm,
)

__all__ = [
    'Arcball', 'ROTATION_IDENTITY', 'SHEAR_IDENTITY', 'TRANSLATION_IDENTITY', 'ZOOM_IDENTITY',
    'arcball_constrain_to_axis', 'arcball_map_to_sphere', 'arcball_nearest_axis', 'clip_matrix', 'compose_matrix',
    'concatenate_matrices', 'decompose_matrix', 'euler_from_matrix', 'euler_from_quaternion', 'euler_matrix',
    'identity_matrix', 'inverse_matrix', 'is_same_transform', 'orthogonalization_matrix', 'projection_from_matrix',
    'projection_matrix', 'quaternion_about_axis', 'quaternion_conjugate', 'quaternion_from_euler',
    'quaternion_from_matrix', 'quaternion_inverse', 'quaternion_matrix', 'quaternion_multiply', 'quaternion_slerp',
    'random_quaternion', 'random_rotation_matrix', 'random_vector', 'reflection_from_matrix', 'reflection_matrix',
    'rotation_from_matrix', 'rotation_matrix', 'scale_from_matrix', 'scale_matrix', 'shear_from_matrix',
    'shear_matrix', 'superimposition_matrix', 'translation_from_matrix', 'translation_matrix', 'unit_vector',
    'vector_norm',
]
