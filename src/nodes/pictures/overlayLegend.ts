import { inEnglish, type Message, msg } from '../../messages/message.ts';
import { keyLegendHeight, type SignRow, withKeyLegend } from '../../reference/figures/keyLegend.ts';
import type { PixelCanvas } from '../../reference/figures/pixelCanvas.ts';
import type { RenderSettings } from '../../scene/view/view.ts';
import { VIEWS } from '../../scene/views/views.ts';
import { OVERLAY_COLORS } from '../../spectrum/display/overlayColors.ts';
import { encodeSrgb } from '../../spectrum/display/srgb.ts';

/** A sign of what is drawn over a picture. */
export type OverlayMark = keyof typeof OVERLAY_COLORS;

/** What is drawn over a picture: a ghost's contours, past and future. */
export const overlayLegendRows = ({
  ghost,
  pastFuture,
}: Pick<RenderSettings, 'ghost' | 'pastFuture'>): readonly (readonly [OverlayMark, Message])[] => [
  ...(ghost === 'none' ? [] : [['contour', msg`Ghost: ${VIEWS[ghost].title}`] as const]),
  ...(pastFuture
    ? [['past', msg`Past, by the world’s clocks`] as const, ['future', msg`Future, by the world’s clocks`] as const]
    : []),
];

const STYLES: Readonly<Record<OverlayMark, SignRow['style']>> = { contour: 'line', past: 'falling', future: 'rising' };

const keyRows = (settings: Pick<RenderSettings, 'ghost' | 'pastFuture'>): readonly SignRow[] =>
  overlayLegendRows(settings).map(([mark, title]) => {
    const [r, g, b] = OVERLAY_COLORS[mark].map((linear) => Math.round(255 * encodeSrgb(linear)));
    return { text: inEnglish(title), color: [r!, g!, b!], style: STYLES[mark] };
  });

/** Height that the legend of what is drawn over a picture of this width adds to it [px]; 0 if nothing is. */
export const overlayLegendHeight = (width: number, settings: Pick<RenderSettings, 'ghost' | 'pastFuture'>): number =>
  keyLegendHeight(width, keyRows(settings));

/** A picture with the legend of what is drawn over it below; the picture itself if nothing is. */
export const withOverlayLegend = (
  picture: PixelCanvas,
  settings: Pick<RenderSettings, 'ghost' | 'pastFuture'>,
): PixelCanvas => withKeyLegend(picture, keyRows(settings));
