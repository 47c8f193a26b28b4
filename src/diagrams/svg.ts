import type { Translate } from '../messages/message.ts';
import { type ColorScheme, lineStyle } from './lineStyle.ts';
import type { Diagram, Mark, MarkRole, PixelPoint } from './marks.ts';

/** Colours of what is not a line of the scene: distinct with all types of colour blindness, and by their dashes and labels. */
const COLORS: Readonly<Record<ColorScheme, Readonly<Record<Exclude<MarkRole, number> | 'background', string>>>> = {
  light: {
    background: '#ffffff',
    frame: '#c5ccd6',
    axis: '#4a5361',
    otherAxis: '#5d4bb5',
    observer: '#5d4bb5',
    pastCone: '#a61b1b',
    futureCone: '#8d95a2',
    slice: '#5d4bb5',
  },
  dark: {
    background: '#14171d',
    frame: '#3a4250',
    axis: '#aeb5c0',
    otherAxis: '#b3a6ff',
    observer: '#b3a6ff',
    pastCone: '#ff8a80',
    futureCone: '#78818f',
    slice: '#b3a6ff',
  },
};

const FONT = "Inter Variable, Inter, 'Noto Sans SC', 'Noto Sans CJK SC', 'PingFang SC', 'Microsoft YaHei', sans-serif";

/** To a hundredth of a pixel. */
const rounded = (value: number): number => Math.round(value * 100) / 100;

/** Paths are in tenths of a pixel: whole numbers become text several times as fast as fractions. */
const PATH_UNITS = 10;
const PATH_SCALE = `transform="scale(${1 / PATH_UNITS})"`;

/** The data of a path through points. */
function path(points: readonly PixelPoint[]): string {
  let d = '';
  for (const [x, y] of points)
    d += `${d === '' ? 'M' : 'L'}${Math.round(PATH_UNITS * x)},${Math.round(PATH_UNITS * y)}`;
  return d;
}

/**
 * The diagram as an SVG document on an opaque background, with title and description in a language.
 * Colours are attributes, not style sheets, so that any program shows them.
 */
export function diagramSvg(diagram: Diagram, scheme: ColorScheme, t: Translate): string {
  const { width, height, marks } = diagram;
  const [title, description] = [escaped(t(diagram.title)), escaped(t(diagram.description))];
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" role="img" font-family="${FONT}" font-size="12">`,
    `<title>${title}</title>`,
    `<desc>${description}</desc>`,
    `<rect width="${width}" height="${height}" fill="${COLORS[scheme].background}"/>`,
    ...marks.map((mark) => markSvg(mark, scheme, t)),
    '</svg>\n',
  ].join('\n');
}

function markSvg(mark: Mark, scheme: ColorScheme, t: Translate): string {
  const color = colorOf(mark.role, scheme);
  switch (mark.kind) {
    case 'lines': {
      const d = mark.lines.map(path).join('');
      const dashes = mark.dashed === undefined ? dashOf(mark) : mark.dashed ? [5, 4] : [];
      const dash =
        dashes.length > 0 ? ` stroke-dasharray="${dashes.map((length) => PATH_UNITS * length).join(' ')}"` : '';
      return `<path d="${d}" fill="none" stroke="${color}" stroke-width="${PATH_UNITS * mark.width}" stroke-linejoin="round"${dash} ${PATH_SCALE}/>`;
    }
    case 'area':
      return `<path d="${path(mark.outline)}Z" fill="${color}" fill-opacity="0.09" ${PATH_SCALE}/>`;
    case 'dot': {
      const title = mark.title === undefined ? '' : `<title>${escaped(t(mark.title))}</title>`;
      const fill = mark.filled ? color : COLORS[scheme].background;
      const [x, y] = mark.at.map(rounded);
      return `<circle cx="${x}" cy="${y}" r="4" fill="${fill}" stroke="${color}" stroke-width="1.75">${title}</circle>`;
    }
    case 'text': {
      const [x, y] = mark.at.map(rounded);
      return `<text x="${x}" y="${y}" fill="${color}" text-anchor="${mark.anchor}">${escaped(t(mark.text))}</text>`;
    }
  }
}

const colorOf = (role: MarkRole, scheme: ColorScheme): string =>
  typeof role === 'number' ? lineStyle(role, scheme).color : COLORS[scheme][role];

/** Curves of the scene have the dashes of their numbers; ticks, which are thinner, have none. */
const dashOf = ({ role, width }: { readonly role: MarkRole; readonly width: number }): readonly number[] =>
  typeof role === 'number' && width > 1.5 ? lineStyle(role, 'light').dash : [];

/** Names come from files: markup, and what XML does not allow, stays text. */
const escaped = (text: string): string =>
  text
    .replaceAll('&', '&amp;')
    .replaceAll('<', '&lt;')
    .replaceAll('>', '&gt;')
    .replaceAll('"', '&quot;')
    // biome-ignore lint/suspicious/noControlCharactersInRegex: XML 1.0 has no such characters
    .replaceAll(/[\u0000-\u0008\u000b\u000c\u000e-\u001f\ufffe\uffff]/g, '\ufffd');
