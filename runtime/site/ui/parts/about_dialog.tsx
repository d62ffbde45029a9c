// The dialog about this page: the workspace's data, the link between its nodes in plain words, and
// a report for bug reports.

import { useEffect, useRef, useState } from 'preact/hooks';
import type { Session } from '../../contract/session.ts';
import { bibtex } from '../model/citation.ts';
import { siteDigest } from '../model/link.ts';
import { formatBytes, formatCount } from '../model/quantities.ts';
import { siteReport } from '../model/report.ts';
import { claimedSignature } from '../model/signature.ts';
import { texts } from '../texts.ts';
import { aboutTexts } from '../texts_about.ts';
import { CopyButton, IconButton } from './button.tsx';
import { readSiteText } from './site_text.ts';

export interface AboutDialogProps {
  readonly session: Session;
  readonly open: boolean;
  /** Whether the site is kept for visits without a network; null while unknown. */
  readonly offline: boolean | null;
  readonly onClose: () => void;
  readonly announce: (text: string) => void;
}

export function AboutDialog({ session, open, offline, onClose, announce }: AboutDialogProps) {
  const dialog = useRef<HTMLDialogElement>(null);
  const [digest, setDigest] = useState<string | null>(null);
  useEffect(() => {
    const element = dialog.current;
    if (element === null || element.open === open) return;
    if (open) {
      element.showModal();
      void siteDigest().then(setDigest);
    } else {
      element.close();
    }
  }, [open]);
  const [signature, setSignature] = useState<string | null>(null);
  const lookForSignature = (): void => {
    void readSiteText('site.json.minisig').then(claimedSignature, () => null).then((found) => {
      setSignature(found === null ? aboutTexts.unsigned : aboutTexts.signed(found.keyId, found.comment));
    });
  };
  const { site, link } = session;
  const entry = bibtex(site, digest, location.href.replace(/[?#].*$/, ''));
  // Names of functions are fetched for crash reports only.
  const files = site.files.filter((file) => !file.path.endsWith('.names'));
  const bytes = files.reduce((sum, file) => sum + file.size, 0);
  const rows: readonly (readonly [string, string])[] = [
    [aboutTexts.workspace, `${site.name} ${site.version}`],
    [aboutTexts.authors, site.authors.map((author) => author.name).join(', ')],
    [aboutTexts.license, site.license],
    [aboutTexts.distro, site.distro],
    [
      aboutTexts.size,
      files.length === 0
        ? ''
        : aboutTexts.sizeOf(formatCount(files.length), formatBytes(bytes)),
    ],
    [aboutTexts.digest, digest ?? ''],
    [aboutTexts.offline, offlineWords(offline)],
    [aboutTexts.generator, site.generator],
  ];
  return (
    <dialog class="about" ref={dialog} aria-labelledby="about-title" onClose={onClose}>
      <header class="about-head">
        <h2 id="about-title">{site.title === '' ? site.name : site.title}</h2>
        <IconButton icon="close" label={aboutTexts.close} onClick={onClose} />
      </header>
      <p>{aboutTexts.what}</p>
      <dl class="facts">
        {rows
          .filter(([, value]) => value.trim() !== '')
          .map(([name, value]) => (
            <div key={name}>
              <dt>{name}</dt>
              <dd>{value}</dd>
            </div>
          ))}
      </dl>
      <p class="about-report">
        <button type="button" class="button" onClick={lookForSignature}>{aboutTexts.whoSigned}</button>
        <span role="status">{signature ?? ''}</span>
      </p>
      {entry === null ? null : (
        <>
          <h3>{aboutTexts.cite}</h3>
          <pre class="about-cite" tabIndex={0} aria-label={aboutTexts.cite}>{entry}</pre>
          <p class="about-report">
            <CopyButton label={aboutTexts.copyCite} words={aboutTexts.copyCite} text={() => entry} announce={announce} />
            <a href="CITATION.cff" download="CITATION.cff">CITATION.cff</a>
          </p>
        </>
      )}
      <p class="about-report">
        <a href="LICENSES.txt">{aboutTexts.licenses}</a>
        <a href="sbom.spdx.json">{aboutTexts.materials}</a>
      </p>
      <h3>{`${aboutTexts.link}: ${texts.link[link]}`}</h3>
      <p>{link === 'shared' ? aboutTexts.sharedLong : aboutTexts.portLong}</p>
      {link === 'port' ? <p>{aboutTexts.portFix}</p> : null}
      <p class="about-report">
        <CopyButton
          label={aboutTexts.copyReport}
          words={aboutTexts.copyReport}
          text={() => siteReport(session, navigator.userAgent, crossOriginIsolated)}
          announce={announce}
        />
        <span>{aboutTexts.reportHint}</span>
      </p>
    </dialog>
  );
}

function offlineWords(offline: boolean | null): string {
  if (offline === null) return '';
  return offline ? aboutTexts.offlineYes : aboutTexts.offlineNo;
}
