import { Text } from '@mantine/core';
import type { ReactNode } from 'react';
import { type Message, msg } from '../../../messages/message.ts';
import { VIEWS } from '../../../scene/views/views.ts';
import { OVERLAY_COLORS } from '../../../spectrum/display/overlayColors.ts';
import { cssColor } from '../../color.ts';
import { useTexts } from '../../language/languageStore.ts';
import { useEditorState } from '../../state/context.tsx';
import './overlayLegend.css';

type LegendMark = keyof typeof OVERLAY_COLORS;

/** Legend of what is drawn over the picture: a ghost's contours, past and future. */
export default function OverlayLegend(): ReactNode {
  const { t } = useTexts();
  const ghost = useEditorState(({ picture }) => picture?.ghost ?? 'none');
  const parts = useEditorState(({ picture }) => picture?.pastFuture === true);
  const rows: readonly (readonly [LegendMark, Message])[] = [
    ...(ghost === 'none' ? [] : ([['contour', msg`Ghost: ${VIEWS[ghost].title}`]] as const)),
    ...(parts
      ? ([
          ['past', msg`Past, by the world’s clocks`],
          ['future', msg`Future, by the world’s clocks`],
        ] as const)
      : []),
  ];
  return (
    <figure className="sl-legend sl-overlay-legend" data-overlay-legend aria-label={t(msg`Legend`)}>
      <ul>
        {rows.map(([mark, title]) => (
          <li key={mark}>
            <span
              className="sl-overlay-mark"
              data-mark={mark}
              style={{ color: cssColor(OVERLAY_COLORS[mark]) }}
              aria-hidden
            />
            <Text size="xs" component="span">
              {t(title)}
            </Text>
          </li>
        ))}
      </ul>
    </figure>
  );
}
