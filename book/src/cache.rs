//! Figures that are kept from one build to the next.
//!
//! A figure is known by its command line, the sources it was compiled from, and the assets it may
//! have read. When one of them changes, it is made again.

use std::collections::BTreeSet;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io;
use std::path::{Path, PathBuf};

use common::chapter::Entry;

use crate::job::Job;
use crate::trouble::Trouble;
use crate::watch;

/// The sources of each chapter with all before it, as they were compiled: `id=hash` by blanks.
const SOURCES: &str = env!("SOURCE_FINGERPRINTS");

/// Changed by hand when what is kept of a job changes its form.
const FORM: u32 = 1;

/// What a job made.
#[derive(Clone, Debug)]
pub struct Made {
    /// What was printed, as text or JSON.
    pub text: String,
    /// The picture, if there is one.
    pub picture: Option<PathBuf>,
    /// The name of the picture in the book.
    pub file: String,
}

/// The folder of kept figures.
#[derive(Debug)]
pub struct Cache {
    folder: PathBuf,
    assets: u64,
}

const TEXT: &str = "output.txt";
const PICTURE: &str = "picture.png";

impl Cache {
    /// The cache in `folder`, for figures that may read the files in `assets`.
    pub fn new(folder: &Path, assets: &Path) -> Self {
        let mut hasher = DefaultHasher::new();
        for path in watch::files(assets) {
            path.strip_prefix(assets).ok().hash(&mut hasher);
            std::fs::read(&path).ok().hash(&mut hasher);
        }
        Self { folder: folder.into(), assets: hasher.finish() }
    }

    /// What `job` made in an earlier build, if nothing has changed since.
    pub fn get(&self, job: &Job, entry: &Entry) -> Option<Made> {
        let name = self.name(job, entry);
        let folder = self.folder.join(&name);
        let text = std::fs::read_to_string(folder.join(TEXT)).ok()?;
        let picture = Some(folder.join(PICTURE)).filter(|path| path.is_file());
        Some(Made { text, picture, file: format!("{name}.png") })
    }

    /// An empty folder for `job` to work in.
    pub fn workplace(&self) -> Result<Workplace, Trouble> {
        let folder = self.folder.join(format!(".making-{}", std::process::id()));
        let fail = |error| Trouble::with(&folder, &error);
        if folder.exists() {
            std::fs::remove_dir_all(&folder).map_err(fail)?;
        }
        std::fs::create_dir_all(&folder).map_err(fail)?;
        Ok(Workplace { folder })
    }

    /// Keeps what `job` printed and the picture it made in `workplace`, all at once.
    pub fn keep(
        &self,
        job: &Job,
        entry: &Entry,
        workplace: &Workplace,
        text: &str,
    ) -> Result<Made, Trouble> {
        let folder = self.folder.join(self.name(job, entry));
        let renamed = || -> io::Result<()> {
            std::fs::write(workplace.folder.join(TEXT), text)?;
            std::fs::write(workplace.folder.join("command.txt"), job.words())?;
            if folder.exists() {
                std::fs::remove_dir_all(&folder)?;
            }
            std::fs::rename(&workplace.folder, &folder)
        };
        renamed().map_err(|error| Trouble::with(&folder, &error))?;
        self.get(job, entry).ok_or_else(|| {
            Trouble::Work(format!("{} was removed while it was written", folder.display()))
        })
    }

    /// Drops all figures but those of `jobs`.
    pub fn drop_others<'a>(
        &self,
        jobs: impl Iterator<Item = (&'a Job, &'a Entry)>,
    ) -> Result<(), Trouble> {
        let kept: BTreeSet<String> = jobs.map(|(job, entry)| self.name(job, entry)).collect();
        let fail = |error| Trouble::with(&self.folder, &error);
        if !self.folder.is_dir() {
            return Ok(());
        }
        for found in std::fs::read_dir(&self.folder).map_err(fail)? {
            let path = found.map_err(fail)?.path();
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            if path.is_dir() && !kept.contains(name.as_ref()) {
                std::fs::remove_dir_all(&path).map_err(fail)?;
            }
        }
        Ok(())
    }

    fn name(&self, job: &Job, entry: &Entry) -> String {
        let sources = SOURCES.split(' ').find_map(|pair| pair.strip_prefix(entry.id));
        let mut hasher = DefaultHasher::new();
        (job.words(), job.keep as u8, sources, self.assets).hash(&mut hasher);
        // Times measured without optimization say nothing about times with it.
        (FORM, cfg!(debug_assertions)).hash(&mut hasher);
        format!("{}-{:016x}", job.package, hasher.finish())
    }
}

/// A folder that a job works in; what is left of it goes away with it.
#[derive(Debug)]
pub struct Workplace {
    folder: PathBuf,
}

impl Workplace {
    /// Where the job's picture goes.
    pub fn picture(&self) -> PathBuf {
        self.folder.join(PICTURE)
    }
}

impl Drop for Workplace {
    fn drop(&mut self) {
        // It has been renamed when all went well.
        let _gone = std::fs::remove_dir_all(&self.folder);
    }
}

#[cfg(test)]
mod tests {
    use super::Cache;
    use crate::fake::CHAPTERS;
    use crate::job::{Job, Keep};

    #[test]
    fn a_figure_is_kept_until_an_asset_changes_or_no_page_needs_it() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let assets = folder.path().join("assets");
        std::fs::create_dir(&assets).expect("it can be made");
        std::fs::write(assets.join("a.obj"), "v 1 2 3").expect("it can be written");
        let fresh = || Cache::new(&folder.path().join("cache"), &assets);
        let (cache, entry) = (fresh(), CHAPTERS[0]);
        let job = |words| Job::parse(words, Keep::Json, CHAPTERS).expect("it is a job");
        let (one, two) = (job("fake --size 1x2"), job("fake --size 2x1"));

        for job in [&one, &two] {
            assert!(cache.get(job, entry).is_none());
            let workplace = cache.workplace().expect("it can be made");
            std::fs::write(workplace.picture(), "p").expect("it can be written");
            cache.keep(job, entry, &workplace, &job.words()).expect("it can be kept");
        }
        let made = fresh().get(&one, entry).expect("it is kept");
        assert_eq!(made.text, "fake --size 1x2");
        assert!(made.picture.is_some());

        cache.drop_others([(&two, entry)].into_iter()).expect("the rest can go");
        assert!(cache.get(&one, entry).is_none() && cache.get(&two, entry).is_some());

        std::fs::write(assets.join("a.obj"), "v 1 2 4").expect("it can be written");
        assert!(fresh().get(&two, entry).is_none());
    }
}
