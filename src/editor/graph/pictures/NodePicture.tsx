import { type ReactNode, useEffect, useRef } from 'react';
import { msg } from '../../../messages/message.ts';
import { formatNumber } from '../../format.ts';
import { useTexts } from '../../language/languageStore.ts';
import { flatNodeId, useCanvas } from '../canvas/canvasState.ts';
import type { CardModel } from '../cards/cardModel.ts';
import { type LuminanceHistogram, STOP_RANGE } from './luminanceHistogram.ts';
import { useNodePicture } from './nodePictures.ts';

/** Picture of a node's result; an empty frame until it is rendered. */
export function NodePicture({ card }: { readonly card: CardModel }): ReactNode {
  const { t } = useTexts();
  const path = useCanvas((state) => state.path);
  const picture = useNodePicture(flatNodeId(path, card.id));
  const canvas = useRef<HTMLCanvasElement>(null);
  const image = picture?.image;
  useEffect(() => {
    if (image) canvas.current?.getContext('2d')?.putImageData(image, 0, 0);
  }, [image]);
  const surfaces = picture !== undefined && !('step' in picture.of);
  const label = t(
    surfaces
      ? msg`Picture of the surfaces that ${t(card.title)} rasterized`
      : msg`Picture of the result of ${t(card.title)}`,
  );
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
  return (
    <svg
      className="sl-node-spread"
      viewBox={`0 0 ${WIDTH} ${HEIGHT + 12}`}
      role="img"
      aria-label={t(
        histogram
          ? msg`Luminance histogram in stops: the median is ${formatNumber(histogram.middle, 2)} EV, ${formatNumber(100 * histogram.over, 2)} % is above white`
          : msg`Luminance histogram: not measured yet`,
      )}
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
