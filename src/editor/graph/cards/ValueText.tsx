import type { ReactNode } from 'react';
import { useTexts } from '../../i18n/i18n.ts';
import type { DisplayValue } from './displayValue.ts';

/** A value as short text, or as its colour. */
export function ValueText({ of }: { readonly of: DisplayValue }): ReactNode {
  const { textOrKey } = useTexts();
  if (of.kind === 'text') return of.text;
  if (of.kind === 'words') return textOrKey(of.key, of.fill);
  return <span className="sl-swatch" style={{ background: of.css }} role="img" aria-label={of.css} />;
}
