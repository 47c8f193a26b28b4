import { listed, msg } from '../../../../messages/message.ts';
import type { BoundingBox } from '../../../../scene/bounds/bounds.ts';
import { report } from '../../diagnostics.ts';
import { attributeOf, textAt, textOf, valueAt } from '../../layer/attributes.ts';
import type { PrimSpec, Value } from '../../layer/layer.ts';
import { attribute, connected, type PrimContent, primSpec, relationship, schemas, uniform } from '../../layer/specs.ts';
import { float, floatTuples, ints, token, tuple } from '../../layer/values.ts';
import type { StageContext } from '../context.ts';

/** What is less opaque than this is not there, as in OpenUSD's own cards. */
const OPACITY_THRESHOLD = 0.1;

/** A face of the box: the corner of each of its four points, counterclockwise from outside, 0 least and 1 greatest by axis. */
interface Card {
  readonly name: string;
  readonly axis: number;
  readonly greatest: boolean;
  readonly corners: readonly (readonly [number, number, number])[];
  /** Whether its own picture is turned upside down, left and right too. */
  readonly turned?: true;
  /** Along which coordinate the picture of the opposite face is mirrored where this one has none. */
  readonly mirrored: 's' | 't';
}

/** As OpenUSD places pictures on cards: the first point has the picture's upper right corner, the next one its upper left. */
const CARDS: readonly Card[] = [
  {
    name: 'XPos',
    axis: 0,
    greatest: true,
    corners: [
      [1, 1, 1],
      [1, 0, 1],
      [1, 0, 0],
      [1, 1, 0],
    ],
    mirrored: 's',
  },
  {
    name: 'XNeg',
    axis: 0,
    greatest: false,
    corners: [
      [0, 0, 1],
      [0, 1, 1],
      [0, 1, 0],
      [0, 0, 0],
    ],
    mirrored: 's',
  },
  {
    name: 'YPos',
    axis: 1,
    greatest: true,
    corners: [
      [0, 1, 1],
      [1, 1, 1],
      [1, 1, 0],
      [0, 1, 0],
    ],
    mirrored: 's',
  },
  {
    name: 'YNeg',
    axis: 1,
    greatest: false,
    corners: [
      [1, 0, 1],
      [0, 0, 1],
      [0, 0, 0],
      [1, 0, 0],
    ],
    mirrored: 's',
  },
  {
    name: 'ZPos',
    axis: 2,
    greatest: true,
    corners: [
      [1, 1, 1],
      [0, 1, 1],
      [0, 0, 1],
      [1, 0, 1],
    ],
    mirrored: 't',
  },
  {
    name: 'ZNeg',
    axis: 2,
    greatest: false,
    corners: [
      [0, 1, 0],
      [1, 1, 0],
      [1, 0, 0],
      [0, 0, 0],
    ],
    turned: true,
    mirrored: 's',
  },
];

/** Of the picture, by point of a card. */
const UVS: readonly (readonly [number, number])[] = [
  [1, 1],
  [0, 1],
  [0, 0],
  [1, 0],
];

/**
 * Quads across the middle of the box (`cross`) or on its faces (`box`), with the pictures of the model, or in its colour where it has none. Of an axis with one picture the other
 * face has it mirrored; axes without pictures are left out, if others have some.
 */
export function cards(context: StageContext, model: PrimSpec, box: BoundingBox, color: readonly number[]): PrimSpec[] {
  const geometry = textAt(model, 'model:cardGeometry', context.startCode) ?? 'cross';
  if (geometry !== 'cross' && geometry !== 'box')
    report(
      context,
      'warning',
      'usd.draw-mode',
      model.path,
      msg`model:cardGeometry is ${geometry}, which is not read (${listed(['cross', 'box'])} are); its cards are a cross`,
    );
  const pictureOf = (card: Card): Value | undefined => {
    const value = valueAt(attributeOf(model, `model:cardTexture${card.name}`), context.startCode);
    return textOf(value) ? value : undefined;
  };
  const hasPictures = CARDS.some(pictureOf);
  return CARDS.flatMap((card) => {
    const own = pictureOf(card);
    const picture = own ?? pictureOf(CARDS.find((other) => other.axis === card.axis && other !== card)!);
    if (hasPictures && !picture) return [];
    const shape = { points: pointsOf(card, box, geometry === 'box'), uvs: uvsOf(card, own !== undefined) };
    const path = `${model.path}/card${card.name}`;
    const mesh = primSpec(path, cardMesh(shape, picture ? `${path}/material` : undefined, color));
    return [picture ? withMaterial(mesh, picture, color) : mesh];
  });
}

const pointsOf = ({ axis, corners }: Card, { min, max }: BoundingBox, onFaces: boolean): number[] =>
  corners.flatMap((corner) =>
    corner.map((side, k) => (k === axis && !onFaces ? (min[k] + max[k]) / 2 : (side === 1 ? max : min)[k])),
  );

function uvsOf({ turned, mirrored }: Card, isOwn: boolean): number[] {
  const flipsS = isOwn ? turned === true : mirrored === 's';
  const flipsT = isOwn ? turned === true : mirrored === 't';
  return UVS.flatMap(([s, t]) => [flipsS ? 1 - s : s, flipsT ? 1 - t : t]);
}

const cardMesh = (
  { points, uvs }: { readonly points: readonly number[]; readonly uvs: readonly number[] },
  material: string | undefined,
  color: readonly number[],
): PrimContent => ({
  type: 'Mesh',
  metadata: schemas('MaterialBindingAPI'),
  properties: [
    uniform('token', 'subdivisionScheme', token('none')),
    attribute('point3f[]', 'points', floatTuples('float3', Float32Array.from(points))),
    attribute('int[]', 'faceVertexCounts', ints(Int32Array.of(4))),
    attribute('int[]', 'faceVertexIndices', ints(Int32Array.of(0, 1, 2, 3))),
    attribute('texCoord2f[]', 'primvars:st', floatTuples('float2', Float32Array.from(uvs)), {
      metadata: new Map([['interpolation', token('vertex')]]),
    }),
    ...(material === undefined
      ? [
          attribute('color3f[]', 'primvars:displayColor', floatTuples('float3', Float32Array.from(color)), {
            metadata: new Map([['interpolation', token('constant')]]),
          }),
        ]
      : [relationship('material:binding', material)]),
  ],
});

/** A card with its material below it: the picture's colour and opacity. */
function withMaterial(card: PrimSpec, picture: Value, color: readonly number[]): PrimSpec {
  const path = `${card.path}/material`;
  const shader = (id: string, properties: PrimContent['properties']): PrimContent => ({
    type: 'Shader',
    properties: [uniform('token', 'info:id', token(id)), ...properties],
  });
  const material = primSpec(path, {
    type: 'Material',
    properties: [connected('token', 'outputs:surface', `${path}/surface.outputs:surface`)],
    inner: new Map([
      [
        'surface',
        shader('UsdPreviewSurface', [
          connected('color3f', 'inputs:diffuseColor', `${path}/picture.outputs:rgb`),
          connected('float', 'inputs:opacity', `${path}/picture.outputs:a`),
          attribute('float', 'inputs:opacityThreshold', float(OPACITY_THRESHOLD)),
          attribute('float', 'inputs:roughness', float(1)),
          attribute('token', 'outputs:surface'),
        ]),
      ],
      [
        'picture',
        shader('UsdUVTexture', [
          attribute('asset', 'inputs:file', picture),
          attribute('float4', 'inputs:fallback', tuple('float4', [...color, 1])),
          attribute('token', 'inputs:wrapS', token('clamp')),
          attribute('token', 'inputs:wrapT', token('clamp')),
          connected('float2', 'inputs:st', `${path}/reader.outputs:result`),
          attribute('float3', 'outputs:rgb'),
          attribute('float', 'outputs:a'),
        ]),
      ],
      [
        'reader',
        shader('UsdPrimvarReader_float2', [
          attribute('string', 'inputs:varname', { type: 'string', data: 'st' }),
          attribute('float2', 'outputs:result'),
        ]),
      ],
    ]),
  });
  return { ...card, children: new Map([['material', material]]) };
}
