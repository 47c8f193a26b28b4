/** The codes of `validate`, which are independent of the scene's format, and their meanings. */
export const SCENE_CODES = {
  'scene.duplicate-path': 'two objects with the same path',
  'mesh.empty': 'a mesh without triangles',
  'mesh.index': 'a triangle with the index of a missing vertex',
  'mesh.length': 'normals or uvs whose number differs from that of the vertices',
  'mesh.material': 'a mesh with a missing material',
  'mesh.degenerate': 'triangles without area',
  'mesh.not-finite': 'a vertex at NaN or infinity',
  'motion.samples': 'samples whose number differs from that of their times',
  'motion.times': 'times that do not increase, or are missing',
  'motion.rest-points': 'a deforming object authored at rest, for which no contraction is defined',
  'motion.not-finite': 'a pose or velocity that is NaN or infinite',
  'motion.cubic': 'a cubic path that could be faster than light: its bend is reduced there',
  'motion.superluminal': 'something moves faster than light',
  'motion.horizon': 'part of an accelerated body lies beyond its horizon, where nothing can keep up with it',
  'object.stretch':
    'a stretch that is not finite, flattens or mirrors, or that of something that has none: a round solid, or deforming points',
  'object.lifetime': 'an object that dies before it is born',
  'light.size': 'a lamp whose size is negative or not finite',
  'light.color': 'a lamp whose colour is not finite',
} as const;

export type SceneCode = keyof typeof SCENE_CODES;

/** Maximum number of diagnostics that are listed one by one per code; further ones are summed up in one. */
export const MAX_PER_CODE = 100;
