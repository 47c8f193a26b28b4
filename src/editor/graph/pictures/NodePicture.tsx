import { type ReactNode, useEffect, useRef } from 'react';
import { formatNumber } from '../../format.ts';
import { useTexts } from '../../i18n/i18n.ts';
import { flatNodeId, useCanvas } from '../canvas/canvasState.ts';
import type { CardModel } from '../cards/cardModel.ts';
import { type LuminanceHistogram, STOP_RANGE } from './luminanceHistogram.ts';
import { useNodePicture } from './nodePictures.ts';

/** Picture of a node's result; an empty frame until it is rendered. */
export function NodePicture({ card }: { readonly card: CardModel }): ReactNode {
  const { t, textOrKey } = useTexts();
  const path = useCanvas((state) => state.path);
  const picture = useNodePicture(flatNodeId(path, card.id));
  const canvas = useRef<HTMLCanvasElement>(null);
  const image = picture?.image;
  useEffect(() => {
    if (image) canvas.current?.getContext('2d')?.putImageData(image, 0, 0);
  }, [image]);
  const surfaces = picture !== undefined && !('step' in picture.of);
  const label = t(surfaces ? 'graph.picture.surfaces' : 'graph.picture', { title: textOrKey(card.title) });
  return (
    <>
      <div className="sl-node-picture">
        {image && <canvas ref={canvas} role="img" aria-label={label} width={image.width} height={image.height} />}
      </div>
      {card.picture === 'metered' && <Histogram histogram={picture?.histogram} />}
    </>
  );
}

const [FROM, TO] = STOP_RANGE;
const WIDTH = 188;
const HEIGHT = 26;
const at = (stop: number): number => (WIDTH * (stop - FROM)) / (TO - FROM);
const TICKS = [-8, -4, 0] as const;

/** Histogram of the luminance that the tone curve gets, over stops; white is at 0. */
function Histogram({ histogram }: { readonly histogram?: LuminanceHistogram }): ReactNode {
  const { t } = useTexts();
  const fill = histogram && { middle: formatNumber(histogram.middle, 2), over: formatNumber(100 * histogram.over, 2) };
  return (
    <svg
      className="sl-node-spread"
      viewBox={`0 0 ${WIDTH} ${HEIGHT + 12}`}
      role="img"
      aria-label={fill ? t('graph.spread', fill) : t('graph.spread.none')}
    >
      {histogram && <path d={outline(histogram.bins)} />}
      {TICKS.map((stop) => (
        <g key={stop} data-white={stop === 0 || undefined}>
          <line x1={at(stop)} x2={at(stop)} y1={0} y2={HEIGHT} />
          <text x={at(stop)} y={HEIGHT + 10}>
            {stop === 0 ? '0 EV' : `\u2212${-stop}`}
          </text>
        </g>
      ))}
    </svg>
  );
}

/** SVG path of the histogram as steps. */
function outline(bins: readonly number[]): string {
  const width = WIDTH / bins.length;
  const tops = bins.map(
    (bin, i) => `L${(i * width).toFixed(1)} ${(HEIGHT * (1 - bin)).toFixed(1)}h${width.toFixed(1)}`,
  );
  return `M0 ${HEIGHT}${tops.join('')}V${HEIGHT}z`;
}
