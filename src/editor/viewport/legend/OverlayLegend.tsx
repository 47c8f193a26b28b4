import { Text } from '@mantine/core';
import type { ReactNode } from 'react';
import { msg } from '../../../messages/message.ts';
import { overlayLegendRows } from '../../../nodes/pictures/overlayLegend.ts';
import { OVERLAY_COLORS } from '../../../spectrum/display/overlayColors.ts';
import { cssColor } from '../../color.ts';
import { useTexts } from '../../language/languageStore.ts';
import { useEditorState } from '../../state/context.tsx';
import './overlayLegend.css';

/** Legend of what is drawn over the picture: a ghost's contours, past and future. */
export default function OverlayLegend(): ReactNode {
  const { t } = useTexts();
  const ghost = useEditorState(({ picture }) => picture?.ghost ?? 'none');
  const pastFuture = useEditorState(({ picture }) => picture?.pastFuture === true);
  return (
    <figure className="sl-legend sl-overlay-legend" data-overlay-legend aria-label={t(msg`Legend`)}>
      <ul>
        {overlayLegendRows({ ghost, pastFuture }).map(([mark, title]) => (
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
