import { toHalf } from '../../../math/half.ts';
import type { DomeLight } from '../../../scene/types.ts';
import type { HalfTexels } from '../../../shaders/tables/halfAtlas.ts';
import { BORDER, writeBordered } from './borderedMap.ts';
import { type DomeLevel, domeMipmaps } from './domeMipmaps.ts';
import { pictureMeans } from './pictureMeans.ts';
import { type Panorama, PREFILTER_SIZE, prefilterDome } from './prefilteredDome.ts';

/** All that a dome's texture has on the GPU of its picture; plain data, which takes a while to make. */
export interface DomeMaps {
  /** The picture and its mip levels. */
  readonly levels: readonly DomeLevel[];
  /** Prefiltered maps (`prefilterDome`), one below the other, with their borders. */
  readonly lobes: HalfTexels;
  /** What moving surfaces need (`pictureMeans`); absent if there are none. */
  readonly means?: HalfTexels;
}

/** How the means of a dome are made: not at all, of few pixels, a quarter of a second, or of many, two. */
export type DomeMeans = 'none' | 'coarse' | 'fine';

/**
 * The maps of a dome's picture.
 * @example
 * const texels = { width: 8, height: 4, data: new Uint8Array(4 * 32).fill(255), colorSpace: 'srgb' } as const;
 * const white = { name: 'white', ...texels, filter: 'linear', wrapS: 'repeat', wrapT: 'clamp' } as const;
 * domeMaps(white, 'none').levels.map(({ width }) => width); // [8, 4, 2, 1]
 */
export function domeMaps(picture: NonNullable<DomeLight['texture']>, means: DomeMeans): DomeMaps {
  return {
    levels: domeMipmaps(picture),
    lobes: stacked(prefilterDome(picture)),
    ...(means !== 'none' && { means: pictureMeans(picture, MEAN_SOURCES[means]) }),
  };
}

/** Size of the panorama that means are taken of. */
const MEAN_SOURCES = { coarse: { width: 32, height: 16 }, fine: PREFILTER_SIZE } as const;

/** Panoramas one below the other, with their borders. */
function stacked(maps: readonly Panorama[]): HalfTexels {
  const [width, height] = [PREFILTER_SIZE.width + 2 * BORDER, PREFILTER_SIZE.height + 2 * BORDER];
  const texels = { data: new Uint16Array(4 * width * height * maps.length).fill(toHalf(1)), width };
  maps.forEach((map, layer) => {
    writeBordered(map, texels, 0, layer * height);
  });
  return texels;
}
