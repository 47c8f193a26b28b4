/** How six files of a cube are named: right, left, up, down, ahead, behind, as `CubeFaces`. */
const NAMES = [
  ['px', 'nx', 'py', 'ny', 'pz', 'nz'],
  ['posx', 'negx', 'posy', 'negy', 'posz', 'negz'],
  ['+x', '-x', '+y', '-y', '+z', '-z'],
  ['right', 'left', 'top', 'bottom', 'front', 'back'],
  ['right', 'left', 'up', 'down', 'front', 'back'],
  ['rt', 'lf', 'up', 'dn', 'ft', 'bk'],
] as const;

/**
 * Paths of the six files of which one is given, in every way of naming that its name fits: the name of a face, alone or behind a separator.
 * Empty if it is not named like a face.
 */
export function faceFiles(path: string): readonly (readonly string[])[] {
  return NAMES.flatMap((names) =>
    names.flatMap((name) => {
      const pattern = new RegExp(`^((?:.*[/_. -])?)(${name.replace('+', '\\+')})(\\.[^./]+)$`, 'i');
      const [, before, face, extension] = pattern.exec(path) ?? [];
      if (face === undefined) return [];
      const isUpper = face === face.toUpperCase() && face !== face.toLowerCase();
      const isCapital = !isUpper && face[0] !== face[0].toLowerCase();
      const written = (other: string): string => {
        if (isUpper) return other.toUpperCase();
        return isCapital ? `${other[0].toUpperCase()}${other.slice(1)}` : other;
      };
      return [names.map((other) => `${before}${written(other)}${extension}`)];
    }),
  );
}
